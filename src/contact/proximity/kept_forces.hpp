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
  /// `twice`: in the first substep of a frame there may be two searches.
  static Result<KeptForces> create(gpu::Device& device, bool twice, std::uint32_t workgroup_size);
  /// Takes over lists, at first or with other room. Errors  OutOfMemory.
  Result<void> bind(const State& state, const ContactPairs& pairs);
  /// Before a search lists pairs anew: makes the table of forces for it. `starts`: it is the first of a frame, where it
  /// is in a frame's first substep.
  void record_search(gpu::ComputePass& pass, bool starts) const;
  /// At the end of a frame.
  void record_frame_end(gpu::ComputePass& pass) const;

 private:
  /// A kernel and what it binds.
  struct Bound {
    gpu::Kernel kernel;
    gpu::BindGroup group;
  };
  /// Fills a list.
  struct Keeping {
    Bound begin, keep;
  };
  void record_keep(gpu::ComputePass& pass, const Keeping& list) const;

  Keeping of_frame_;                  // the list of a frame's end
  std::array<Keeping, 2> of_search_;  // that of a search, by whether it may be the first of a frame
  Bound clear_;
  std::array<Bound, 2> place_;    // by the same
  std::size_t first_search_ = 1;  // 0: there are such that are not
  std::size_t near_room_ = 0;
};

}  // namespace weft::contact
