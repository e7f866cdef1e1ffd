// Cloth on the flat end of a rod, a mesh whose side is round and meets it at a crease: a plane, in double.
#include <cmath>
#include <numbers>

#include "rig.hpp"

using namespace weft;

namespace {

constexpr double kGravity = 9.81;  // [m/s²]

/// Round y, its upper end at 0; two rings and a fan over each end, as programs make a cylinder.
mesh::TriangleMesh rod(double radius, std::uint32_t facets) {
  mesh::TriangleMesh made;
  for (const float y : {-1.0F, 0.0F})
    for (std::uint32_t i = 0; i < facets; ++i) {
      const double angle = 2 * std::numbers::pi * i / facets;
      made.positions.push_back(
          {static_cast<float>(radius * std::cos(angle)), y, static_cast<float>(-radius * std::sin(angle))});
    }
  made.positions.push_back({0, -1, 0});
  made.positions.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i < facets; ++i) {
    const std::uint32_t next = (i + 1) % facets;
    made.triangles.insert(made.triangles.end(), {{i, next, facets + next},
                                                 {i, facets + next, facets + i},
                                                 {2 * facets, next, i},
                                                 {2 * facets + 1, facets + i, facets + next}});
  }
  return made;
}

struct Slide {
  double radius, size, slope, friction, residual;  // [m], [m], [°]
  int frames;
};

/// A patch that begins left of the middle, near the rim, and ends on the flat end still.
void check_slide(const Slide& slide) {
  CAPTURE(slide.radius);
  CAPTURE(slide.friction);
  CAPTURE(slide.residual);
  const double angle = slide.slope * std::numbers::pi / 180, down = kGravity * std::sin(angle),
               onto = kGravity * std::cos(angle), begin = 0.55 * slide.radius;
  constexpr double kThickness = 0.002;
  const auto text = [](double number) { return std::to_string(number); };
  auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "gravity": [)" + text(down) + ", " + text(-onto) +
          R"(, 0], "solver": {"kind": "multigrid", "residual": )" + text(slide.residual) +
          R"(}, "contact": {"thickness": )" + text(kThickness) +
          R"(, "self": false}, "cloths": [{"grid": [4, 4], "size": [)" + text(slide.size) + ", " +
          text(slide.size) + R"(], "plane": "xz", "density": 0.2, "friction": )" + text(slide.friction) +
          R"(, "stiffness": {"structural": 1500, "shear": 500, "bend": 0}, "transform": {"translate": [)" +
          text(-begin) + ", " + text(kThickness) +
          R"(, 0]}}], "colliders": [{"kind": "mesh", "mesh": "rod.obj"}]})",
      "test.json");
  REQUIRE_OK(scene);
  auto made = reference::Simulation::create(
      *scene,
      {.cloths = {{}}, .objects = {rod(slide.radius, 32)}, .object_colliders = {0}, .deformations = {{}}});
  REQUIRE_OK(made);
  const std::vector<Vec3d> start = made->positions();
  advance(*made, slide.frames);
  // A backward difference from rest is ahead by at most a substep of its final speed.
  const double time = slide.frames / 60.0, pull = down - slide.friction * onto;
  const double way = 0.5 * pull * time * time, step = 1.0 / 360;
  REQUIRE(way + slide.size < 0.9 * (begin + slide.radius));
  for (std::size_t n = 0; n < start.size(); ++n) {
    const Vec3d moved = made->positions()[n] - start[n];
    CHECK(std::abs(moved.x - way) < 0.02 * way + pull * time * step);
    CHECK(std::abs(moved.z) < 0.01 * way);
    CHECK(std::abs(moved.y) < 0.05 * kThickness);
  }
}

}  // namespace

TEST_CASE(
    "a patch slides over the flat end of a rod as over a plane, though the rod's side is round, in double") {
  for (const double residual : {1e-2, 1e-4})
    for (const Slide& slide : {Slide{0.02, 0.006, 60, 0.5, residual, 4},
                               {0.02, 0.006, 35, 0.2, residual, 5},
                               {0.05, 0.012, 30, 0.0, residual, 7},
                               {0.1, 0.012, 20, 0.1, residual, 9}})
      check_slide(slide);
}
