#include "bench/hanging.hpp"

#include "bench/drawn_frames.hpp"

namespace weft::bench {
namespace {

Result<Row> measure(gpu::Device& device, Row row, Formulation formulation, bool quick) {
  WEFT_CHECK(sim::check_node_count(static_cast<std::uint64_t>(row.side) * row.side, device));
  WEFT_TRY(experiment, make_hanging_sheet(row.side, formulation));
  const std::uint32_t steps = quick ? 16 : 256;
  WEFT_TRY(substeps, fix_step(experiment.scene, experiment.assets, steps));
  {
    const std::uint64_t before = device.allocated_bytes();
    WEFT_TRY(world, sim::World::create(device, experiment.scene, experiment.assets));
    for (int frame = 0; frame < 2; ++frame) WEFT_CHECK(world->advance_frame());
    WEFT_CHECK(world->finish());
    WEFT_TRY(snapshot, world->snapshot());
    describe(row, *world, substeps);
    row.state_hash = snapshot.hash();
    WEFT_CHECK(time_row(row, *world, quick ? 300 : 500, 5));
    row.gpu_bytes = device.allocated_bytes() - before;
  }
  WEFT_TRY(frame,
           time_drawn_frames(device, experiment.scene, experiment.assets, nullptr, quick ? 100 : 500, 5));
  row.paper_frame = frame;
  return row;
}

}  // namespace

Result<void> run_hanging(gpu::Device& device, const Selection& selection,
                         const std::function<Result<void>(const Row&)>& done) {
  std::vector<std::uint32_t> sides = selection.sides;
  if (sides.empty() && selection.quick) sides = {64, 100, 128};
  if (sides.empty()) sides = {64, 100, 128, 200, 256, 400, 512, 800, 2048};
  for (const std::uint32_t side : sides)
    for (std::size_t k = 0; k < std::size(kFormulations); ++k) {
      if (!selection.has_variant(hanging_variants()[k])) continue;
      Row begun;
      begun.object = "none";
      begun.variant = name_of(kFormulations[k]);
      begun.side = side;
      WEFT_TRY(row, or_skipped(measure(device, begun, kFormulations[k], selection.quick), begun));
      WEFT_CHECK(done(row));
    }
  return {};
}

}  // namespace weft::bench
