#pragma once

#include <array>

#include "gpu/kernel.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// Answers pairs of features by impulses with friction, and holds vertices back so that they pass through nothing.
/// Source: docs/contact.md, equations (2) to (7).
/// Reads   steps; position[parity] [m]; pairs.
/// Writes  position[1 - parity], velocity[1 - parity]; statistics: vertices truncated, whether pairs are to be
///         looked for.
/// Errors  Shader, OutOfMemory.
class Respond {
 public:
  Respond() = default;
  /// `interval`: substeps from one that may search to the next.
  static Result<Respond> create(gpu::Device& device, std::uint32_t interval, std::uint32_t workgroup_size);
  /// Takes over lists, at first or with other room. Errors  OutOfMemory.
  Result<void> bind(const State& state, const ContactPairs& pairs);
  /// Sums the velocity changes of the measured pairs at each vertex.
  void record_impulses(gpu::ComputePass& pass) const;
  /// Gives each vertex that change and holds it back.
  void record_hold_back(gpu::ComputePass& pass) const;

 private:
  gpu::Kernel impulse_, respond_;
  std::array<gpu::BindGroup, 2> impulse_groups_, respond_groups_;  // by parity
  std::size_t pair_room_ = 0, vertex_count_ = 0;
};

}  // namespace weft::contact
