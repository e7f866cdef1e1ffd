#include "bench/row.hpp"

#include "contact/rules/contact_steps.hpp"

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

double dispatches_per_step(sim::World& world) {
  const std::uint32_t interval = world.plan().method().search_interval;
  const auto dispatches = [&](std::uint32_t substeps) {
    return static_cast<double>(world.frame_commands(0, substeps).dispatch_count());
  };
  return (dispatches(2 * interval) - dispatches(interval)) / interval;  // what a frame does once is in both
}

void describe(Row& row, sim::World& world, std::uint32_t substeps) {
  row.nodes = world.model().vertex_count();
  row.springs = world.element_count(ElementKind::Spring);
  for (const mesh::TriangleMesh& object : world.assets().objects)
    row.object_triangles += object.triangles.size();
  row.substeps = substeps;
  row.dispatches_per_step = dispatches_per_step(world);
  row.bytes_per_step =
      4.0 * sizeof(Vec4f) * static_cast<double>(row.nodes);  // position and velocity, in and out
}

Result<void> time_row(Row& row, sim::World& world, double budget_ms, std::uint32_t least_submits,
                      const Pose* pose) {
  WEFT_TRY(step, time_steps(world, budget_ms, least_submits, pose));
  row.step = step;
  row.real_time_factor = 1000.0 / 60 / (step.median * row.substeps);
  if (pose != nullptr) {
    // Kernels are timed over two steps with the motions of the frame before: those of the pose's first frame, so that
    // what is moved jumps by no more than a step.
    WEFT_CHECK(begin_at(*pose, world));
    WEFT_CHECK(world.restore(pose->state));
  }
  WEFT_TRY(kernels, sim::time_kernels(world, least_submits));
  row.kernels = std::move(kernels);
  return {};
}

}  // namespace weft::bench
