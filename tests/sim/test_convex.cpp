// Scenes with convex hulls as obstacles.
#include <cmath>

#include "contact/reference/pushes/gjk.hpp"
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

namespace {

/// Points of a sphere of radius 0.25 m about the origin, in rings; the facets' sagitta is below 0.25 (1 - cos(pi /
/// 24)), 2.2 mm, in each direction.
std::string sphere_points() {
  std::string points = "[[0, 0.25, 0], [0, -0.25, 0]";
  constexpr int kRings = 24;
  for (int ring = 1; ring < kRings; ++ring)
    for (int k = 0; k < 2 * kRings; ++k) {
      const double polar = 3.14159265358979 * ring / kRings, around = 3.14159265358979 * k / kRings;
      points += ", [" + text_of(0.25 * std::sin(polar) * std::cos(around)) + ", " +
                text_of(0.25 * std::cos(polar)) + ", " + text_of(0.25 * std::sin(polar) * std::sin(around)) +
                "]";
    }
  return points + "]";
}

std::vector<Vec3d> places_after(gpu::Device& device, const scene::Scene& scene, std::uint32_t frames) {
  auto world = world_of(device, scene);
  advance(*world, frames);
  const auto snapshot = world->snapshot();
  REQUIRE_OK(snapshot);
  std::vector<Vec3d> places;
  for (const Vec4f& p : snapshot->position) places.push_back(p.xyz().to<double>());
  return places;
}

const std::string kSlab =
    R"({"kind": "convex", "points": [[-0.4, 0, -0.4], [0.4, 0, -0.4], [-0.4, 0, 0.4], [0.4, 0, 0.4],
    [-0.4, 0.3, -0.4], [0.4, 0.3, -0.4], [-0.4, 0.3, 0.4], [0.4, 0.3, 0.4]]})";

}  // namespace

TEST_CASE("a sheet that falls on a convex box by bvh rests at the thickness above it") {
  GpuFixture fixture;
  const scene::Scene scene = sheet_scene("bvh", kSlab);
  const std::vector<Vec3d> places = places_after(fixture.device(), scene, 60);
  double lowest = 1, highest = 0;
  for (const Vec3d& p : places) {
    lowest = std::min(lowest, p.y - 0.3);
    highest = std::max(highest, p.y - 0.3);
  }
  // The pushes end there, but for half a unit each (2^-16 m or less) and the fall of a substep.
  CHECK(lowest > 0.01 - 1e-4);
  CHECK(highest < 0.01 + 1e-4);
}

TEST_CASE("paper and bvh have the same bits over convex bodies, and double has the same contacts") {
  GpuFixture fixture;
  const std::string collider = R"({"kind": "convex", "points": )" + kPoints + R"(}, {"kind": "box",
      "center": [0.2, 0.1, 0.2], "size": [0.2, 0.2, 0.2]})";
  const scene::Scene bvh = sheet_scene("bvh", collider);
  auto first = world_of(fixture.device(), bvh);
  auto second = world_of(fixture.device(), sheet_scene("paper", collider));
  advance(*first, 14);
  advance(*second, 14);
  CHECK(hash_of(*first) == hash_of(*second));
  CHECK(first->totals().contacts == second->totals().contacts);
  CHECK(first->totals().contacts > 50);
  const auto assets = load_assets(bvh, kModels);
  REQUIRE_OK(assets);
  auto exact = reference::Simulation::create(bvh, *assets);
  REQUIRE_OK(exact);
  for (int frame = 0; frame < 14; ++frame) REQUIRE(exact->advance_frame());
  const auto snapshot = first->snapshot();
  REQUIRE_OK(snapshot);
  double most = 0;
  for (std::size_t v = 0; v < exact->positions().size(); ++v)
    most = std::max(most, length(snapshot->position[v].xyz().to<double>() - exact->positions()[v]));
  // Counts of GJK where the sheet ends: of the pairs whose boxes are near.
  const reference::ConvexBody body(assets->objects.at(0));
  std::size_t near = 0, iterations = 0, most_iterations = 0;
  for (const mesh::Triangle& nodes : exact->triangles()) {
    const auto& at = exact->positions();
    const reference::TrianglePoints triangle{at[nodes[0]], at[nodes[1]], at[nodes[2]]};
    const Vec3d low = min(min(triangle.a, triangle.b), triangle.c),
                high = max(max(triangle.a, triangle.b), triangle.c);
    const Vec3d between = max(low - body.high, body.low - high);
    if (std::max({between.x, between.y, between.z}) > 0.01) continue;
    const std::size_t taken = reference::contact_by_gjk(triangle, body).iterations;
    ++near;
    iterations += taken;
    most_iterations = std::max(most_iterations, taken);
  }
  MESSAGE(near << " of " << exact->triangles().size() << " pairs near, "
               << static_cast<double>(iterations) / static_cast<double>(near)
               << " iterations in the mean, most " << most_iterations);
  CHECK(near > 10);
  CHECK(most_iterations < 64);
  // The reference finds contacts by all pairs of features, and not by GJK. Where two points of a triangle are as near,
  // either may be taken, so the sheets part slowly.
  const auto contacts = static_cast<double>(first->totals().contacts);
  CHECK(std::abs(static_cast<double>(exact->contacts()) - contacts) <= 0.02 * contacts);
  CHECK(most < 0.002);
}

TEST_CASE(
    "a sheet over a fine hull of a sphere lies where it lies over the sphere, within the facets and the "
    "cells") {
  GpuFixture fixture;
  const std::vector<Vec3d> hull = places_after(
      fixture.device(), sheet_scene("bvh", R"({"kind": "convex", "points": )" + sphere_points() + "}"), 45);
  const std::vector<Vec3d> sphere = places_after(
      fixture.device(), sheet_scene("bvh", R"({"kind": "sphere", "center": [0, 0, 0], "radius": 0.25})"), 45);
  // Near the top, where the sheet rests. The sphere meets nodes, and the hull triangles, whose nodes then lie higher by
  // the cells' sagitta: those of half a diagonal of 50 mm, 2.4 mm at this radius.
  double mean_hull = 0, mean_sphere = 0;
  int count = 0;
  for (std::size_t v = 0; v < hull.size(); ++v) {
    if (length(Vec3d{sphere[v].x, 0, sphere[v].z}) > 0.1 || length(Vec3d{hull[v].x, 0, hull[v].z}) > 0.1)
      continue;
    mean_hull += length(hull[v]);
    mean_sphere += length(sphere[v]);
    ++count;
  }
  REQUIRE(count > 5);
  CHECK(std::abs(mean_hull - mean_sphere) / count < 0.0022 + 0.0024);
}
