#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contact/proximity/near_pairs.hpp"
#include "contact/proximity/pair_search.hpp"
#include "contact/proximity/respond.hpp"
#include "contact/proximity/rigid_bodies.hpp"
#include "contact/rules/solved_contact.hpp"
#include "contact/stages/stages.hpp"

namespace weft::contact {

/// The lengths of proximity contact; names as in docs/contact.md. All in [m].
struct ProximityLengths {
  double thickness = 0;       // h
  double self_thickness = 0;  // h_s; 0: cloth does not meet cloth
  double most_reach = 0;      // b₁: the largest slack of a vertex
};

/// Errors  Input: the thickness is not positive, or below the resolution of f32 at the cloth.
Result<ProximityLengths> proximity_lengths(const Model& model, const scene::Contact& contact);

struct ProximitySetup {
  std::uint32_t substeps = 1;  // the most of any frame
  std::uint32_t interval = 4;  // of them from one that may search to the next
  double step = 0;             // length of a substep, where frames are not cut [s]
  SolvedContact solved;
  std::uint32_t workgroup_size = gpu::kDefaultWorkgroupSize;
};

/// Contact by proximity: pairs of near features, answered by impulses.
/// Reads   state.steps; state.position[parity]; pairs.predicted: the solver's velocities.
/// Writes  pairs; state.position[1 - parity], state.velocity[1 - parity]; state.statistics.
/// Errors  Input, Limit, Shader, OutOfMemory.
/// Source  docs/contact.md.
class Proximity : public Stages {
 public:
  Proximity() = default;
  static Result<Proximity> create(gpu::Device& device, const GpuModel& model, const State& state,
                                  const ContactPairs& pairs, const scene::Scene& scene,
                                  const ColliderMeshes& meshes, const ProximitySetup& setup);
  /// Takes over lists with other room. Errors  Limit, OutOfMemory.
  Result<void> bind_lists(gpu::Device& device, const State& state, const ContactPairs& pairs);
  /// As of Respond.
  bool adapt(const Statistics& report) { return respond_.adapt(report); }
  void press(gpu::ComputePass& pass) const override;
  void press_again(gpu::ComputePass& pass) const override;
  void search(gpu::ComputePass& pass) const override;
  void measure(gpu::ComputePass& pass) const override;
  void answer(gpu::ComputePass& pass) const override { respond_.record_impulses(pass, rigid_); }
  void hold_back(gpu::ComputePass& pass) const override {
    respond_.record_hold_back(pass, search_.patches());
    rigid_.record_arrive(pass);
  }
  void end_frame(gpu::ComputePass& pass) const { search_.record_frame_end(pass); }
  /// Writes where the colliders are in each substep of the frame that begins at `time` [s].
  void write_places(gpu::Device& device, const scene::Scene& scene, double time, double step,
                    std::uint32_t substeps);

  const ProximityLengths& lengths() const { return lengths_; }
  const PairSearch& pair_search() const { return search_; }
  const RigidBodies& rigid() const { return rigid_; }

 private:
  Result<void> create_kernels(gpu::Device& device, const State& state, const ProximitySetup& setup);
  void move_colliders(gpu::ComputePass& pass) const;
  Result<void> bind_own(gpu::Device& device, const State& state, const ContactPairs& pairs);

  ProximityLengths lengths_;
  PairSearch search_;
  NearPairs near_;
  Respond respond_;
  RigidBodies rigid_;
  gpu::Kernel move_points_, press_, press_pairs_, evaluate_;
  gpu::BindGroup move_group_;
  // By parity.
  std::array<gpu::BindGroup, 2> press_groups_, press_pair_groups_, evaluate_groups_;
  std::array<gpu::BindGroup, 2> press_again_groups_, press_pair_again_groups_;
  gpu::Buffer<ColliderPlace> places_;
  gpu::Buffer<Vec4f> shapes_;
  gpu::Buffer<std::uint32_t> rings_;
  std::vector<ColliderPlace> rows_;  // of one frame; kept so that a frame allocates nothing
  std::uint32_t pair_room_ = 0, near_room_ = 0, substeps_ = 1, interval_ = 4;
  bool presses_ = false, holds_pairs_ = false;  // a solver answers obstacles, and pairs of one cloth
};

}  // namespace weft::contact
