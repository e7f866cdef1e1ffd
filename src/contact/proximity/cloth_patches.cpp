#include "contact/proximity/cloth_patches.hpp"

#include <algorithm>

namespace weft::contact {
namespace {

constexpr std::uint32_t kQuads = 64;  // of a patch that a workgroup tests at once

}  // namespace

Result<ClothPatches> ClothPatches::create(gpu::Device& device, const PatchTable& table, const State& state,
                                          const ContactPairs& pairs, std::uint32_t workgroup_size) {
  ClothPatches made;
  made.count_ = table.places.size();
  WEFT_SET(made.openness_,
           gpu::Buffer<Vec4f>::create(device, std::max<std::size_t>(2 * made.count_, 1), "patches"));
  if (made.count_ == 0) return made;
  WEFT_SET(made.places_, gpu::Buffer<PatchPlace>::create_from(device, table.places, "patch places"));
  WEFT_SET(made.find_open_, gpu::Kernel::create(device, "contact/proximity/find_open.wgsl", {}, kQuads));
  const auto keep = [&](std::size_t round, double end_ways) {
    return gpu::Kernel::create(device, "contact/proximity/keep_open.wgsl",
                               {{"kRound", static_cast<double>(kMostSeparations + round + 1)},
                                {"kFirst", round == 0 ? 1.0 : 0.0},
                                {"kEndWays", end_ways}},
                               workgroup_size);
  };
  WEFT_SET(made.end_ways_, keep(0, 1));
  for (std::size_t round = 0; round < kRounds; ++round) WEFT_SET(made.mark_[round], keep(round, 0));
  for (std::size_t parity = 0; parity < 2; ++parity) {
    const auto &start = state.position[parity], &end = state.position[1 - parity];
    WEFT_SET(made.find_groups_[parity],
             made.find_open_.bind({state.steps, start, made.places_, state.statistics, made.openness_}));
    const auto bind = [&](const gpu::Kernel& kernel) {
      return kernel.bind({start, end, made.places_, made.openness_, pairs.vertex_contacts, state.statistics});
    };
    WEFT_SET(made.end_groups_[parity], bind(made.end_ways_));
    for (std::size_t round = 0; round < kRounds; ++round)
      WEFT_SET(made.mark_groups_[round][parity], bind(made.mark_[round]));
  }
  return made;
}

void ClothPatches::record_search(gpu::ComputePass& pass) const {
  if (count_ > 0) find_open_.dispatch(pass, find_groups_[pass.parity()], kQuads * count_);
}

void ClothPatches::record_marks(gpu::ComputePass& pass, std::size_t round) const {
  if (count_ > 0)
    mark_[round].dispatch_strided(pass, mark_groups_[round][pass.parity()], kCellQuads * count_);
}

void ClothPatches::record_ends(gpu::ComputePass& pass) const {
  if (count_ > 0) end_ways_.dispatch_strided(pass, end_groups_[pass.parity()], kCellQuads * count_);
}

}  // namespace weft::contact
