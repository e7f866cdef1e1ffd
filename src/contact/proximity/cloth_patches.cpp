#include "contact/proximity/cloth_patches.hpp"

#include <algorithm>

namespace weft::contact {
namespace {

constexpr std::uint32_t kQuads = 64;  // of a patch that a workgroup tests at once

}  // namespace

Result<ClothPatches> ClothPatches::create(gpu::Device& device, const PatchTable& table, const State& state,
                                          const ContactPairs& pairs, std::size_t separations,
                                          std::uint32_t workgroup_size) {
  ClothPatches made;
  made.count_ = table.places.size();
  WEFT_SET(made.openness_,
           gpu::Buffer<Vec4f>::create(device, std::max<std::size_t>(2 * made.count_, 1), "patches"));
  if (made.count_ == 0) return made;
  WEFT_SET(made.places_, gpu::Buffer<PatchPlace>::create_from(device, table.places, "patch places"));
  const auto find = [&](bool early) {
    return gpu::Kernel::create(device, "contact/proximity/find_open.wgsl",
                               {{"kPredicted", early ? 0.0 : 1.0}}, kQuads);
  };
  WEFT_SET(made.find_open_, find(false));
  WEFT_SET(made.find_early_, find(true));
  const std::vector<Round> rounds = holding_rounds(true);
  const auto keep = [&](double end_ways) {
    return RoundKernel::create(device, "contact/proximity/keep_open.wgsl", {{"kEndWays", end_ways}}, rounds,
                               workgroup_size);
  };
  WEFT_SET(made.mark_, keep(0));
  WEFT_SET(made.end_ways_, keep(1));
  WEFT_SET(made.unfold_,
           SeparationRounds::create(device, "contact/proximity/unfold.wgsl", separations, workgroup_size));
  for (std::size_t parity = 0; parity < 2; ++parity) {
    const auto &start = state.position[parity], &end = state.position[1 - parity];
    const auto bind_find = [&](const gpu::Kernel& kernel, const gpu::Buffer<Vec4f>& motion) {
      return kernel.bind({state.steps, start, motion, made.places_, state.statistics, made.openness_});
    };
    WEFT_SET(made.find_groups_[parity], bind_find(made.find_open_, end));
    WEFT_SET(made.early_groups_[parity], bind_find(made.find_early_, state.velocity[parity]));
    for (RoundKernel* kernel : {&made.mark_, &made.end_ways_})
      WEFT_CHECK(kernel->bind(
          parity, {start, end, made.places_, made.openness_, pairs.vertex_contacts, state.statistics}));
    WEFT_CHECK(made.unfold_.bind(parity, {state.steps, start, end, state.velocity[1 - parity], made.places_,
                                          made.openness_, pairs.vertex_contacts, state.statistics}));
  }
  return made;
}

void ClothPatches::record_search(gpu::ComputePass& pass, bool early) const {
  if (count_ == 0) return;
  const gpu::Kernel& kernel = early ? find_early_ : find_open_;
  kernel.dispatch(pass, (early ? early_groups_ : find_groups_)[pass.parity()], kQuads * count_);
}

void ClothPatches::record_counts(gpu::ComputePass& pass, std::size_t round) const {
  if (count_ > 0) unfold_.count.dispatch_strided(pass, round, kCellQuads * count_);
}

void ClothPatches::record_gifts(gpu::ComputePass& pass, std::size_t round) const {
  if (count_ > 0) unfold_.give.dispatch_strided(pass, round, kCellQuads * count_);
}

void ClothPatches::record_marks(gpu::ComputePass& pass, std::size_t round) const {
  if (count_ > 0) mark_.dispatch_strided(pass, round, kCellQuads * count_);
}

void ClothPatches::record_ends(gpu::ComputePass& pass, std::size_t round) const {
  if (count_ > 0) end_ways_.dispatch_strided(pass, round, kCellQuads * count_);
}

}  // namespace weft::contact
