#pragma once

#include <array>
#include <cstdint>

#include "contact/proximity/patch_table.hpp"
#include "gpu/kernel.hpp"
#include "state/contact_pairs.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// The rounds of a substep are numbered: pairs of cloth that may meet are separated in up to kMostSeparations, of which
/// the last has that number, and cloth is then held back in kRounds. Mirrors: state/contact.wgsl,
/// reference/proximity/truncate.cpp.
inline constexpr std::size_t kMostSeparations = 6, kRounds = 3;
/// The number of a round of `count` that separate.
constexpr double separation_number(std::size_t round, std::size_t count) {
  return static_cast<double>(kMostSeparations + 1 + round - count);
}

/// Patches of cloths that are grids, whose own pairs are not searched while they are open, and which are kept from
/// folding in every substep. Source: docs/contact.md, Patches.
class ClothPatches {
 public:
  ClothPatches() = default;
  /// Reads   state.steps; state.position[parity] [m], at the start of the substep; state.statistics.
  /// Writes  openness().
  /// Errors  Shader, OutOfMemory.
  static Result<ClothPatches> create(gpu::Device& device, const PatchTable& table, const State& state,
                                     const ContactPairs& pairs, std::uint32_t workgroup_size);

  /// In a search, before candidates are found: which patches are open.
  void record_search(gpu::ComputePass& pass) const;

  /// Of a round that holds vertices back: marks what would fold.
  /// Reads   both positions [m], the second where ways end. Writes  pairs.vertex_contacts; state.statistics.
  void record_marks(gpu::ComputePass& pass, std::size_t round) const;
  /// In the first, after anything else that marks: says how far each vertex may go. Reads and writes the same.
  void record_ends(gpu::ComputePass& pass) const;

  /// Two for each patch: its axes, and λ in the first one's w.
  const gpu::Buffer<Vec4f>& openness() const { return openness_; }

 private:
  std::size_t count_ = 0;
  gpu::Buffer<PatchPlace> places_;
  gpu::Buffer<Vec4f> openness_;
  gpu::Kernel find_open_, end_ways_;
  std::array<gpu::Kernel, kRounds> mark_;
  std::array<gpu::BindGroup, 2> find_groups_, end_groups_;  // by parity
  std::array<std::array<gpu::BindGroup, 2>, kRounds> mark_groups_;
};

}  // namespace weft::contact
