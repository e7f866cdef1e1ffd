// Two substeps in one dispatch against one after the other: the same bits, whatever acts on the sheet.
#include "world_rig.hpp"

using namespace weft;

namespace {

scene::Scene sheet(std::uint32_t nx, std::uint32_t ny, std::uint32_t substeps, const std::string& more = "") {
  auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"}, "contact": {"method": "none"}, "drag": 0.4,
    "time": {"frame": 0.002, "substeps": )" +
          std::to_string(substeps) + R"(}, "cloths": [{"grid": [)" + std::to_string(nx) + ", " +
          std::to_string(ny) + R"(], "size": [1, 0.7], "density": 0.3, "damping": 0.005, "pins": ["top_left"],
    "stiffness": {"structural": 400, "shear": 150, "bend": 15, "bending": 1e-4})" +
          more + "}",
      "sheet.json");
  REQUIRE_OK(scene);
  return std::move(*scene);
}

/// That both ways end alike, and that the quicker one has half the dispatches.
void check_alike(gpu::Device& device, const scene::Scene& scene, std::uint32_t frames) {
  auto one = world_of(device, scene, {.two_steps = false});
  auto two = world_of(device, scene, {.two_steps = true});
  advance(*one, frames);
  advance(*two, frames);
  CHECK(hash_of(*one) == hash_of(*two));
  const auto dispatches = [&](sim::World& world) {
    return world.frame_commands(0, world.substeps()).dispatch_count();
  };
  const std::size_t cloths = scene.cloths.size();
  CHECK(dispatches(*one) - dispatches(*two) == cloths * (one->substeps() / 2));
}

}  // namespace

TEST_CASE("two substeps at once end in the bits of one after the other, for grids of any size") {
  GpuFixture fixture;
  for (const auto& [nx, ny] : {std::pair{2U, 2U}, {3U, 17U}, {16U, 8U}, {17U, 9U}, {70U, 31U}}) {
    CAPTURE(nx);
    CAPTURE(ny);
    check_alike(fixture.device(), sheet(nx, ny, 12, "}]"), 5);
  }
}

TEST_CASE("an odd number of substeps ends with one by itself, also after a reset and from a snapshot") {
  GpuFixture fixture;
  const scene::Scene scene = sheet(21, 30, 7, "}]");
  check_alike(fixture.device(), scene, 3);
  check_alike(fixture.device(), sheet(21, 30, 1, "}]"), 4);
  auto world = world_of(fixture.device(), scene, {.two_steps = true});
  advance(*world, 3);
  const std::string hash = hash_of(*world);
  const auto half = world->snapshot();
  REQUIRE_OK(half);
  advance(*world, 2);
  const std::string later = hash_of(*world);
  REQUIRE(world->reset());
  advance(*world, 3);
  CHECK(hash_of(*world) == hash);
  REQUIRE(world->restore(*half));
  advance(*world, 2);
  CHECK(hash_of(*world) == later);
}

TEST_CASE(
    "two substeps at once heed motions, grabs, gusts, kinds of springs that are not there, and several "
    "cloths") {
  GpuFixture fixture;
  check_alike(
      fixture.device(),
      sheet(
          40, 25, 6,
          R"(, "motions": [{"nodes": "right", "kind": "rotation", "axis": [1, 0, 0], "center": [0, 0, 0], "speed": 9}],
                "grabs": [{"node": "bottom_left", "path": [{"time": 0, "point": [0, 0, 0.3]}]}]}],
                "wind": {"velocity": [2, 0.5, 1], "gusts": 0.6, "wavelength": 0.3})"),
      4);
  check_alike(fixture.device(), sheet(19, 33, 8, R"(}, {"grid": [18, 5], "size": [0.4, 0.2], "damping": 0,
                "stiffness": {"structural": 300, "shear": 0, "bend": 0}, "node_mass": 0.001,
                "transform": {"translate": [0, 1, 0]}}])"),
              4);
}

TEST_CASE("where there is contact, or a cloth of another shape, substeps stay one by one") {
  GpuFixture fixture;
  scene::Scene scene =
      sheet(12, 12, 4, R"(}], "colliders": [{"kind": "plane", "point": [0, -2, 0], "normal": [0, 1, 0]}])");
  scene.contact.method = scene::ContactMethod::Proximity;
  auto asked = world_of(fixture.device(), scene, {.two_steps = true});
  auto plain = world_of(fixture.device(), scene, {.two_steps = false});
  CHECK(asked->frame_commands(0, 4).dispatch_count() == plain->frame_commands(0, 4).dispatch_count());
}
