#pragma once

#include <array>

#include "gpu/kernel.hpp"
#include "state/contact_pairs.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// Gives records to the listed pairs that are near in a substep. Source: src/contact/proximity/find_near.wgsl.
/// Reads   state.steps; state.position[parity] [m]; pairs.predicted [m/s]; the colliders' points [m].
/// Writes  pairs; state.statistics.
/// Errors  Shader, OutOfMemory.
class NearPairs {
 public:
  NearPairs() = default;
  /// `presses`: also before a solver has predicted.
  static Result<NearPairs> create(gpu::Device& device, bool presses, std::uint32_t workgroup_size);
  /// Takes over lists, at first or with other room. Errors  OutOfMemory.
  Result<void> bind(const State& state, const ContactPairs& pairs, const gpu::Buffer<Vec4f>& points);
  void record(gpu::ComputePass& pass) const;
  /// Before a solver has predicted, by the velocities: pairs of cloth with cloth alone, but in a frame's first substep.
  void record_early(gpu::ComputePass& pass) const;
  /// The same by the velocities that lead to where it has come.
  void record_again(gpu::ComputePass& pass) const;

 private:
  gpu::Kernel kernel_, early_;
  std::array<gpu::BindGroup, 2> groups_, early_groups_, again_groups_;  // by parity
  bool presses_ = false;
  std::size_t pair_room_ = 0;
};

}  // namespace weft::contact
