#include "bench/measure.hpp"

#include <algorithm>
#include <chrono>

#include "solver/registry.hpp"

namespace weft::bench {

Result<Timing> time_repeats(double budget_ms, std::uint32_t least, double parts,
                            const std::function<Result<void>()>& work) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> times;
  double spent = 0;
  while (times.size() < least || spent < budget_ms) {
    const auto start = Clock::now();
    WEFT_CHECK(work());
    const double milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    spent += milliseconds;
    times.push_back(milliseconds / parts);
  }
  std::sort(times.begin(), times.end());
  return Timing{times[times.size() / 2], times.front()};
}

Result<Timing> time_steps(sim::World& world, double budget_ms, std::uint32_t least_frames) {
  return time_repeats(budget_ms, least_frames, world.substeps(), [&]() -> Result<void> {
    WEFT_CHECK(world.advance_frame());
    return world.finish();
  });
}

Result<std::uint32_t> fix_step(scene::Scene& scene, const sim::Assets& assets, std::uint32_t steps) {
  WEFT_TRY(model, build_model(scene, assets.cloths));
  scene.time.frame = 1.0 / 60;
  scene.time.substeps.reset();
  const scene::SolverKind kind = choose_solver(scene, model).kind;
  WEFT_TRY(substeps, substeps_of(scene, kind, find_step_limit(kind, scene, model)));
  scene.time.frame = steps * (1.0 / 60) / substeps;
  scene.time.substeps = steps;
  return substeps;
}

Row describe(sim::World& world, std::uint32_t substeps) {
  Row row;
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
  return row;
}

}  // namespace weft::bench
