#pragma once

#include <array>
#include <cstdint>

#include "contact/proximity/patch_table.hpp"
#include "contact/proximity/round_kernel.hpp"
#include "gpu/kernel.hpp"
#include "state/contact_pairs.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// Patches of cloths that are grids, whose own pairs are not searched while they are open, and which are kept from
/// folding in every substep. Source: docs/contact.md, Patches.
class ClothPatches {
 public:
  ClothPatches() = default;
  /// Reads   state.steps; at the start of the substep state.position[parity] [m], state.velocity[parity] [m/s]; where
  ///         ways are predicted to end state.position[1 - parity] [m]; state.statistics.
  /// Writes  openness().
  /// Errors  Shader, OutOfMemory.
  static Result<ClothPatches> create(gpu::Device& device, const PatchTable& table, const State& state,
                                     const ContactPairs& pairs, std::size_t separations,
                                     std::uint32_t workgroup_size);

  /// In a search, before candidates are found: which patches are open, and stay so on the ways of this substep;
  /// `early` by the velocities.
  void record_search(gpu::ComputePass& pass, bool early) const;

  /// Of a round that separates pairs: what would fold counts, at its corners, and gives them what opens it.
  /// Reads   both positions [m], the second where ways end; velocity[1 - parity] [m/s].
  /// Writes  pairs.vertex_contacts; state.statistics.
  void record_counts(gpu::ComputePass& pass, std::size_t round) const;
  void record_gifts(gpu::ComputePass& pass, std::size_t round) const;
  /// Of a round that holds vertices back: marks what would fold.
  /// Reads   both positions [m], the second where ways end. Writes  pairs.vertex_contacts; state.statistics.
  void record_marks(gpu::ComputePass& pass, std::size_t round) const;
  /// In the first, after anything else that marks: says how far each vertex may go. Reads and writes the same.
  void record_ends(gpu::ComputePass& pass, std::size_t round) const;

  /// Two for each patch: its axes, and λ in the first one's w.
  const gpu::Buffer<Vec4f>& openness() const { return openness_; }

 private:
  std::size_t count_ = 0;
  gpu::Buffer<PatchPlace> places_;
  gpu::Buffer<Vec4f> openness_;
  gpu::Kernel find_open_, find_early_;
  SeparationRounds unfold_;
  RoundKernel mark_, end_ways_;
  std::array<gpu::BindGroup, 2> find_groups_, early_groups_;  // by parity
};

}  // namespace weft::contact
