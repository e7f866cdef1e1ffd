#include "bench/row.hpp"

namespace weft::bench {

Row skipped_row(Row begun, const std::string& why) {
  begun.nodes = static_cast<std::uint64_t>(begun.side) * begun.side;
  begun.skipped = why;
  return begun;
}

Result<Row> or_skipped(Result<Row> measured, const Row& begun) {
  if (measured || !skips_row(measured.error())) return measured;
  return skipped_row(begun, measured.error().message);
}

void describe(Row& row, sim::World& world, std::uint32_t substeps) {
  row.nodes = world.model().vertex_count();
  row.springs = world.spring_count();
  for (const mesh::TriangleMesh& object : world.assets().objects)
    row.object_triangles += object.triangles.size();
  row.substeps = substeps;
  constexpr double kFramePasses = 3;  // guard, keep, surface: once a frame, for one cloth
  row.dispatches_per_step =
      (static_cast<double>(world.frame_commands(0, world.substeps()).dispatch_count()) - kFramePasses) /
      world.substeps();
  row.bytes_per_step =
      4.0 * sizeof(Vec4f) * static_cast<double>(row.nodes);  // position and velocity, in and out
}

Result<void> time_row(Row& row, sim::World& world, double budget_ms, std::uint32_t least_submits) {
  WEFT_TRY(step, time_steps(world, budget_ms, least_submits));
  row.step = step;
  row.real_time_factor = 1000.0 / 60 / (step.median * row.substeps);
  WEFT_TRY(kernels, time_kernels(world, least_submits));
  row.kernels = std::move(kernels);
  return {};
}

}  // namespace weft::bench
