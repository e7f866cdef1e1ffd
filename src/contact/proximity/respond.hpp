#pragma once

#include <array>
#include <span>

#include "contact/proximity/cloth_patches.hpp"
#include "contact/proximity/edge_limits.hpp"
#include "contact/proximity/held_edges.hpp"
#include "contact/proximity/rigid_bodies.hpp"
#include "contact/rules/contact_law.hpp"
#include "contact/rules/yielding_edges.hpp"
#include "gpu/kernel.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// Answers pairs of features by impulses with friction, separates those that would meet, and holds vertices back so
/// that they pass through nothing. Source: docs/contact.md, equations (2) to (7).
/// Reads   steps; position[parity] [m]; pairs; the colliders' points [m].
/// Writes  position[1 - parity], velocity[1 - parity]; pairs; statistics: vertices truncated, whether pairs are to be
///         looked for.
/// Errors  Shader, OutOfMemory.
class Respond {
 public:
  struct Setup {
    std::uint32_t interval = 4;  // substeps from one that may search to the next
    ImpulseRule impulses;
    std::uint32_t separations = 1;         // rounds; no more than kMostSeparations
    bool self = false;                     // whether cloth meets cloth
    bool presses = false;                  // a solver's matrix holds vertices at obstacles
    bool balances = false;                 // SolvedContact
    bool rigid = false;                    // whether there are rigid bodies
    std::span<const LimitedEdge> edges;    // of cloth with a strain limit
    std::span<const mesh::Edge> yielding;  // beside ways that are held back; may be none
    double yielding_time = 0;              // YieldingEdges::time [s]
    PushTimes push_times;
    std::uint32_t workgroup_size = gpu::kDefaultWorkgroupSize;
  };
  Respond() = default;
  static Result<Respond> create(gpu::Device& device, const Setup& setup);
  /// Takes over lists, at first or with other room. Errors  OutOfMemory.
  Result<void> bind(gpu::Device& device, const State& state, const ContactPairs& pairs,
                    const gpu::Buffer<Vec4f>& points, const gpu::Buffer<std::uint32_t>& rigid);
  /// Takes in what a frame has reported, also one that is to be repeated since cloth was pressed in it. True: impulses
  /// are recorded otherwise from now on.
  bool adapt(const Statistics& report);
  /// Sums the velocity changes of the measured pairs at each vertex.
  void record_impulses(gpu::ComputePass& pass, const RigidBodies& rigid) const;
  /// Gives each vertex that change, separates pairs of cloth, and holds vertices back, also from folding the open
  /// patches.
  void record_hold_back(gpu::ComputePass& pass, const ClothPatches& patches) const;

 private:
  Setup setup_;
  bool has_pressed() const { return setup_.impulses.pressed > setup_.impulses.iterations; }

  gpu::Kernel first_impulse_, impulse_, last_impulse_, add_, respond_;
  gpu::Kernel ask_respond_;  // responds where pressed cloth's iterations are not recorded
  // By parity.
  std::array<gpu::BindGroup, 2> first_impulse_groups_, impulse_groups_, last_impulse_groups_, add_groups_,
      respond_groups_, ask_respond_groups_;
  std::uint32_t recorded_ = 1;  // iterations of impulses
  std::uint32_t calm_ = 0;      // frames since cloth was pressed
  gpu::Buffer<Vec4f> begun_;    // of heavy cloth: each record's force before it went ahead [N]
  /// The rounds in which pairs of cloth that may meet are separated, and edges kept within their limit.
  std::size_t separation_count_ = 0;
  SeparationRounds separate_;
  RoundKernel moves_;
  EdgeLimits edges_;
  HeldEdges held_edges_;
  /// The rounds in which cloth is held back: from obstacles that it comes to from afar, and from other cloth.
  std::size_t holding_count_ = 0;
  RoundKernel find_meeting_, hold_back_;
  std::size_t pair_room_ = 0, near_room_ = 0, vertex_count_ = 0;
};

}  // namespace weft::contact
