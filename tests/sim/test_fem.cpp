// Newton's method in a world: what a run says that it has not solved.
#include "world_rig.hpp"

using namespace weft;

namespace {

sim::Totals hung(gpu::Device& device, int side, int substeps, int systems, std::uint32_t frames) {
  const std::string nodes = std::to_string(side);
  const scene::Scene scene = shipped_scene(
      "hanging", {{"solver", R"({"kind": "fem", "iterations": )" + std::to_string(systems) + "}"},
                  {"cloths.0.grid", "[" + nodes + "," + nodes + "]"},
                  {"time.substeps", std::to_string(substeps)}});
  auto world = world_of(device, scene);
  advance(*world, frames);
  return world->totals();
}

}  // namespace

TEST_CASE("what rounding leaves of the equation is not called unsolved: more systems leave as much") {
  GpuFixture fixture;
  for (const int side : {8, 24}) {
    CAPTURE(side);
    const sim::Totals few = hung(fixture.device(), side, 8, 2, 3),
                      many = hung(fixture.device(), side, 8, 16, 3);
    CHECK(few.unsolved == 0);
    CHECK(many.unsolved == 0);
    CHECK(many.iterations > 4 * few.iterations);  // they all were taken,
    CHECK(many.residual > 0.5F * few.residual);   // and brought nothing
  }
}

TEST_CASE("what more systems would have solved is called unsolved") {
  GpuFixture fixture;
  const sim::Totals one = hung(fixture.device(), 24, 2, 1, 20), many = hung(fixture.device(), 24, 2, 16, 20);
  CHECK(one.unsolved > 20);  // of 40 substeps
  CHECK(one.residual > 0.01F);
  CHECK(many.unsolved == 0);
}
