// The shipped scenes of contact, small: after every frame nothing has passed through anything; and where obstacles are
// meshes or move, the same comes out twice (test_contact_bits.cpp has the others).
#include <algorithm>
#include <cmath>

#include "contact/reference/proximity/audit.hpp"
#include "scene/motion.hpp"
#include "world_rig.hpp"

using namespace weft;

namespace {

using Overrides = std::vector<scene::Override>;

Overrides with_grid(Overrides overrides, int side = 24) {
  overrides.push_back({"cloths.0.grid", "[" + std::to_string(side) + "," + std::to_string(side) + "]"});
  return overrides;
}

struct Found {
  std::size_t self_crossings = 0, crossings = 0, inside = 0;
};

/// The audit of a state. Meshes and boxes of these scenes stay; spheres and planes are met as they stand now.
Found audit(const sim::World& world, const std::vector<Vec3d>& positions) {
  Found found;
  const reference::Surfaces cloth{positions, world.model().host.triangles};
  found.self_crossings = reference::self_crossings(cloth).size();
  for (const mesh::TriangleMesh& object : world.assets().objects) {
    const std::vector<Vec3d> corners = reference::widened(object.positions);
    found.crossings += reference::crossings(cloth, {corners, object.triangles}).size();
  }
  for (const scene::Collider& collider : world.scene().colliders) {
    if (const auto* plane = std::get_if<scene::ColliderPlane>(&collider))
      found.inside += reference::below_plane(positions, *plane).count;
    if (const auto* sphere = std::get_if<scene::ColliderSphere>(&collider)) {
      const Vec3d center =
          sphere->motion ? scene::motion_at(*sphere->motion, world.time())(sphere->center) : sphere->center;
      found.inside += reference::inside_capsule(positions, center, center, sphere->radius).count;
    }
  }
  return found;
}

std::string check_run(gpu::Device& device, const scene::Scene& scene, std::uint32_t frames, bool audited) {
  auto world = world_of(device, scene);
  std::string hash;
  std::uint32_t bad_frames = 0;
  for (std::uint32_t frame = 1; frame <= frames; ++frame) {
    advance(*world, 1);
    if (!audited && frame < frames) continue;
    const auto snapshot = world->snapshot();
    REQUIRE_OK(snapshot);
    hash = snapshot->hash();
    if (!audited) continue;
    std::vector<Vec3d> positions;
    for (const Vec4f& node : snapshot->position) positions.push_back(node.xyz().to<double>());
    const bool finite = std::all_of(positions.begin(), positions.end(), [](const Vec3d& p) {
      return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
    REQUIRE(finite);
    const Found found = audit(*world, positions);
    if (found.self_crossings + found.crossings + found.inside + world->totals().crossings == 0) continue;
    if (bad_frames++ == 0)
      MESSAGE("frame ", frame, ": ", found.self_crossings, " crossings of cloth with cloth, ",
              found.crossings, " with objects, ", found.inside, " vertices inside, ",
              world->totals().crossings, " crossings that the search saw");
  }
  if (audited) {
    CHECK(bad_frames == 0);
    CHECK(world->totals().contact_overflow == 0);
    MESSAGE(world->substeps(), " substeps, stretch ", world->totals().max_stretch, ", contacts ",
            world->totals().contacts);
  }
  return hash;
}

void check_once(const std::string& name, std::uint32_t frames, const Overrides& overrides = {},
                int side = 24) {
  CAPTURE(name);
  GpuFixture fixture;
  check_run(fixture.device(), shipped_scene(name, with_grid(overrides, side)), frames, true);
}

void check_implicit(const std::string& name, std::uint32_t frames, Overrides overrides = {}) {
  overrides.push_back(scene::override_solver("multigrid"));
  check_once(name, frames, overrides);
}

void check_twice(const std::string& name, std::uint32_t frames, const Overrides& overrides = {}) {
  CAPTURE(name);
  GpuFixture fixture;
  const scene::Scene scene = shipped_scene(name, with_grid(overrides));
  const std::string hash = check_run(fixture.device(), scene, frames, true);
  CHECK(check_run(fixture.device(), scene, frames, false) == hash);
}

}  // namespace

TEST_CASE("a sheet falls on the sphere and passes through nothing") { check_once("drape-sphere", 20); }
TEST_CASE("long: a sheet falls on the armadillo, passes through nothing, and does so twice") {
  check_twice("drape-armadillo", 20);
}
TEST_CASE("long: a sheet falls on the dragon, passes through nothing, and does so twice") {
  check_twice("drape-dragon", 20);
}
TEST_CASE("a sheet begins to twist, twice the same") { check_twice("twist", 10); }
TEST_CASE("long: a sheet is wrung into a rope and passes nowhere through itself") {
  check_once("twist", 200);
}
TEST_CASE("long: what is pressed in the middle of a rope of finer cloth passes nowhere through itself") {
  check_once("twist", 132, {}, 64);
}
TEST_CASE("long: by sweeps: a sheet is wrung into a rope and passes nowhere through itself") {
  check_once("twist", 125,
             {scene::override_solver("pbd"), {"solver.iterations", "4"}, {"time.substeps", "32"}}, 48);
}
TEST_CASE("sheets drop on each other and pass through nothing") {
  check_once("stack", 12, {{"cloths.0.copies.count", "3"}});
}
TEST_CASE("sixteen sheets that drop on each other come to rest, one above the other") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), shipped_scene("stack", {{"cloths.0.grid", "[6,6]"}}));
  advance(*world, 120);
  const auto snapshot = world->snapshot();
  REQUIRE_OK(snapshot);
  std::vector<Vec3d> positions;
  double fastest = 0;
  for (const Vec4f& velocity : snapshot->velocity)
    fastest = std::max(fastest, static_cast<double>(length(velocity.xyz())));
  for (const Vec4f& node : snapshot->position) positions.push_back(node.xyz().to<double>());
  std::vector<double> heights(16);
  for (std::size_t node = 0; node < positions.size(); ++node) heights[node / 36] += positions[node].y / 36;
  MESSAGE("largest speed ", fastest, ", heights from ", heights.front(), " to ", heights.back());
  // They met at up to 1.4 m/s; of that energy no node has a hundredth left.
  CHECK(fastest < 0.14);
  CHECK(std::is_sorted(heights.begin(), heights.end()));
  CHECK(heights.back() > 0.07);  // of 80 mm, were no layer pressed thinner
  const Found found = audit(*world, positions);
  CHECK(found.self_crossings + found.inside + world->totals().crossings == 0);
}
TEST_CASE("a sheet falls into the funnel, passes through nothing, and does so twice") {
  check_twice("funnel", 20);
}
TEST_CASE("long: a sheet gets to the neck of the funnel and passes through nothing") {
  check_once("funnel", 100);
}
TEST_CASE("a flag in a storm passes nowhere through itself") { check_once("flag", 20); }
TEST_CASE("long: a flag folds on itself in a storm and passes nowhere through itself") {
  check_once("flag", 150);
}
TEST_CASE("long: a balloon falls onto a sheet and passes through nothing") { check_once("balloon", 24); }
TEST_CASE("a ball flies into a sheet and not through it, twice the same") {
  // Nearer, so that it strikes in the seventh frame.
  check_twice("shot", 16, {{"colliders.0.motion.start", "0"}, {"colliders.0.center", "[0.08, 0, -0.6]"}});
}
TEST_CASE("a sheet on an incline passes through nothing") { check_once("incline", 15); }

TEST_CASE("implicit: a sheet falls on the sphere and passes through nothing") {
  check_implicit("drape-sphere", 40);
}
TEST_CASE("implicit: a sheet begins to twist and passes nowhere through itself") {
  check_implicit("twist", 20);
}
TEST_CASE("implicit: sheets drop on each other and pass through nothing") {
  check_implicit("stack", 25, {{"cloths.0.copies.count", "3"}});
}
TEST_CASE("implicit: a sheet falls into the funnel and passes through nothing") {
  check_implicit("funnel", 30);
}
TEST_CASE("implicit: a flag in a storm passes nowhere through itself") { check_implicit("flag", 40); }
TEST_CASE("implicit: a ball flies into a sheet and not through it") {
  check_implicit("shot", 16, {{"colliders.0.motion.start", "0"}, {"colliders.0.center", "[0.08, 0, -0.6]"}});
}
TEST_CASE("implicit: a sheet slides down an incline and passes through nothing") {
  check_implicit("incline", 15);
}
TEST_CASE("long: implicit: a sheet falls on the armadillo and passes through nothing") {
  check_implicit("drape-armadillo", 60);
}
TEST_CASE("long: implicit: a sheet falls on the dragon and passes through nothing") {
  check_implicit("drape-dragon", 60);
}
TEST_CASE("long: implicit: a sheet is wrung into a rope and passes nowhere through itself") {
  check_implicit("twist", 200);
}
TEST_CASE("long: implicit: a sheet gets to the neck of the funnel and passes through nothing") {
  check_implicit("funnel", 100);
}
TEST_CASE("long: implicit: a flag folds on itself in a storm and passes nowhere through itself") {
  check_implicit("flag", 150);
}
