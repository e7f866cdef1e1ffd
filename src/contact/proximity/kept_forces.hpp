#pragma once

#include <array>

#include "gpu/kernel.hpp"
#include "state/contact_pairs.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// Keeps the forces of pairs that act beyond a search and beyond the end of a frame, so that the next substep begins
/// with them. Source: docs/contact.md, Impulse; src/contact/proximity/kept_forces.wgsl.
/// Reads   steps; pairs.contacts; statistics.
/// Writes  pairs.kept.
/// Errors  Shader, OutOfMemory.
class KeptForces {
 public:
  KeptForces() = default;
  static Result<KeptForces> create(gpu::Device& device, std::uint32_t workgroup_size);
  /// Takes over lists, at first or with other room. Errors  OutOfMemory.
  Result<void> bind(const State& state, const ContactPairs& pairs);
  /// Before a search lists pairs anew: makes the table of forces for it.
  void record_search(gpu::ComputePass& pass) const;
  /// At the end of a frame.
  void record_frame_end(gpu::ComputePass& pass) const;

 private:
  void record_keep(gpu::ComputePass& pass, std::size_t list) const;

  std::array<gpu::Kernel, 2> begin_, keep_;  // by list
  gpu::Kernel clear_, place_;
  std::array<gpu::BindGroup, 2> begin_groups_, keep_groups_;
  gpu::BindGroup clear_group_, place_group_;
  std::size_t near_room_ = 0;
};

}  // namespace weft::contact
