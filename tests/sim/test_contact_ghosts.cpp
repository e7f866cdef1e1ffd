// A flat floor of triangles is a floor: closed forms of sheets that slide over it, or it under them.
#include <cmath>

#include "contact_rig.hpp"

using namespace weft;

namespace {

struct Slide {
  double cell = 0.005;  // [m]; 0: the floor is a box
  double friction = 0;
  double speed = 0;  // of the floor, along x [m/s]
  double slope = 0;  // down along x
  int side = 5;      // nodes
  std::uint32_t frames = 6;
  std::string solver = "mass_spring";
};

/// How far a sheet that lies on the floor goes along x [m].
double way_of(gpu::Device& device, const Slide& slide) {
  const double way = slide.speed * slide.frames / 60;
  const std::string motion =
      slide.speed > 0
          ? R"(, "motion": {"kind": "line", "direction": [1, 0, 0], "speed": )" + text_of(slide.speed) + "}"
          : "";
  const double size =
      slide.cell == 0.002 ? 0.04 : 0.1;  // of the sheet [m]: lists of fine triangles take long
  const double begin = -0.6 * size - way, end = 0.6 * size + 0.15 + (slide.slope > 0 ? 0.15 : 0);
  const std::string shape = slide.cell > 0 ? R"("kind": "mesh", "mesh": "floor.obj")"
                                           : R"("kind": "box", "center": [0, -0.1, 0], "size": [4, 0.2, 1])";
  const std::string side = std::to_string(slide.side);
  const scene::Scene scene = contact_scene(
      R"("gravity": [)" + text_of(kGravity * std::sin(slide.slope)) + "," +
      text_of(-kGravity * std::cos(slide.slope)) + R"(, 0], "time": {"substeps": 6},
      "solver": {"kind": ")" +
      slide.solver + R"("}, "contact": {"method": "proximity", "thickness": 0.005, "self": false},
      "cloths": [{"grid": [)" +
      side + "," + side + R"(], "size": [)" + text_of(size) + "," + text_of(size) +
      R"(], "plane": "xz", "density": 0.3,
      "damping": 0.0003, "stiffness": {"structural": 0.5, "shear": 0.1, "bend": 0.003},
      "transform": {"translate": [0.0013, 0.005, 0.0007]}}], "colliders": [{)" +
      shape + R"(, "friction": )" + text_of(slide.friction) + motion + "}]");
  const auto assets = load_assets(scene, [&](const std::string&) -> Result<mesh::TriangleMesh> {
    return floor_of(slide.cell, begin, end, size + 0.06);
  });
  const auto world = world_from(device, scene, assets);
  const double before = Moment(*world).mean_position().x;
  advance(*world, slide.frames);
  const Moment now(*world);
  REQUIRE(now.finite());
  const double gone = now.mean_position().x - before;
  MESSAGE(slide.solver, " cell ", 1000 * slide.cell, " mm, friction ", slide.friction, ", ", slide.speed,
          " m/s, slope ", slide.slope, ": way ", 1000 * gone, " mm, height ", 1000 * now.mean_position().y,
          " mm, contacts ", world->totals().contacts, ", truncated ", world->totals().truncated);
  return gone;
}

constexpr double kCells[] = {0.002, 0.005, 0.02};

/// Half g t² times a part.
double fallen(double part, std::uint32_t frames) { return 0.5 * part * kGravity * frames * frames / 3600.0; }

}  // namespace

TEST_CASE("a floor of triangles that moves without friction leaves a sheet where it is") {
  GpuFixture fixture;
  for (const double cell : kCells)
    for (const double speed : {1.0, 3.0})
      CHECK(std::abs(way_of(fixture.device(), {.cell = cell, .speed = speed})) < 0.02 * fallen(0.5, 6));
}

TEST_CASE("a floor of triangles that moves drags a sheet by its friction and no more, as a box does") {
  GpuFixture fixture;
  const double box = way_of(fixture.device(), {.cell = 0, .friction = 0.5, .speed = 3});
  CHECK(box == doctest::Approx(fallen(0.5, 6)).epsilon(0.02).scale(0));
  for (const double cell : kCells) {
    const double way = way_of(fixture.device(), {.cell = cell, .friction = 0.5, .speed = 3});
    CHECK(way == doctest::Approx(fallen(0.5, 6)).epsilon(0.02).scale(0));
    CHECK(way == doctest::Approx(box).epsilon(0.02).scale(0));
  }
}

TEST_CASE("on a slope of triangles without friction a sheet slides with g sin") {
  GpuFixture fixture;
  const double slope = std::acos(-1.0) / 9;
  for (const double cell : {0.0, 0.002, 0.005, 0.02})
    CHECK(way_of(fixture.device(), {.cell = cell, .slope = slope, .frames = 24}) ==
          doctest::Approx(fallen(std::sin(slope), 24)).epsilon(0.02).scale(0));
}

TEST_CASE("with implicit steps too a sheet goes the same way over triangles as over a box") {
  GpuFixture fixture;
  Slide slide{.cell = 0.02, .speed = 3, .solver = "multigrid"};
  CHECK(std::abs(way_of(fixture.device(), slide)) < 0.02 * fallen(0.5, 6));
  slide.friction = 0.5;
  const double way = way_of(fixture.device(), slide);
  slide.cell = 0;
  CHECK(way == doctest::Approx(way_of(fixture.device(), slide)).epsilon(0.02).scale(0));
}
