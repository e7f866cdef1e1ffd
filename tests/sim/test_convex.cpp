// Scenes with convex hulls as obstacles.
#include <cmath>

#include "contact_rig.hpp"
#include "reference/simulation.hpp"

using namespace weft;

namespace {

/// A sheet of 0.6 m over the origin, and one obstacle.
scene::Scene sheet_scene(const std::string& method, const std::string& collider,
                         const std::string& more = "") {
  return contact_scene(
      R"("solver": {"kind": "mass_spring"}, "contact": {"method": ")" + method +
      R"(", "thickness": 0.01}, "cloths": [{"grid": [13, 13], "size": [0.6, 0.6], "plane": "xz",
                          "transform": {"translate": [0.013, 0.32, 0.007]}, "density": 0.2, "damping": 0.25,
                          "stiffness": {"structural": 500, "shear": 200, "bend": 20}}], "colliders": [)" +
      collider + "]" + more);
}

const std::string kPoints =
    R"([[-0.2, 0, -0.2], [0.2, 0, -0.2], [-0.2, 0, 0.2], [0.2, 0, 0.2], [0.05, 0.25, 0.02], [-0.1, 0.2, 0.1],
        [0, 0.1, 0], [0.1, 0, 0.1]])";

}  // namespace

TEST_CASE(
    "proximity over a convex hull is proximity over the hull's mesh, bit for bit, in f32 and in double") {
  GpuFixture fixture;
  const std::string common =
      R"("friction": 0.3, "motion": {"kind": "line", "direction": [1, 0, 0], "speed": 0.1})";
  const scene::Scene convex =
      sheet_scene("proximity", R"({"kind": "convex", "points": )" + kPoints + ", " + common + "}");
  const auto assets = load_assets(convex, kModels);
  REQUIRE_OK(assets);
  CHECK(assets->objects.at(0).positions.size() == 6);
  const scene::Scene mesh =
      sheet_scene("proximity", R"({"kind": "mesh", "mesh": "hull.obj", )" + common + "}");
  const auto mesh_assets = load_assets(
      mesh, [&](const std::string&) -> Result<mesh::TriangleMesh> { return assets->objects.at(0); });
  auto first = world_from(fixture.device(), convex, assets);
  auto second = world_from(fixture.device(), mesh, mesh_assets);
  advance(*first, 16);
  advance(*second, 16);
  CHECK(hash_of(*first) == hash_of(*second));
  CHECK(first->totals().contacts > 100);
  auto exact = reference::Simulation::create(convex, *assets);
  auto other = reference::Simulation::create(mesh, *mesh_assets);
  REQUIRE_OK(exact);
  REQUIRE_OK(other);
  for (int frame = 0; frame < 14; ++frame) {
    REQUIRE(exact->advance_frame());
    REQUIRE(other->advance_frame());
  }
  CHECK(exact->hash() == other->hash());
  CHECK(exact->contacts() > 100);
}
