// The world: time, determinism, freezing, resetting.
#include <cmath>
#include <cstring>

#include "world_rig.hpp"

using namespace weft;

namespace {

scene::Scene small_scene(const std::string& members = "") {
  auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"},
          "time": {"substeps": 7}, "contact": {"method": "none"},
    "cloths": [{"grid": [13, 9], "size": [1, 1], "density": 0.3, "damping": 0.005, "pins": ["top_left"],
    "stiffness": {"structural": 100, "shear": 50, "bend": 5}}])" +
                                      members + "}",
                                  "small.json");
  REQUIRE_OK(scene);
  return std::move(*scene);
}

}  // namespace

TEST_CASE("a world repeats bit for bit, also after a reset, with an odd number of substeps") {
  GpuFixture fixture;
  auto a = world_of(fixture.device(), small_scene()), b = world_of(fixture.device(), small_scene());
  advance(*a, 11);
  advance(*b, 11);
  const std::string hash = hash_of(*a);
  CHECK(hash_of(*b) == hash);
  advance(*a, 5);
  CHECK(hash_of(*a) != hash);
  REQUIRE(a->reset());
  CHECK(a->frame() == 0);
  advance(*a, 11);
  CHECK(hash_of(*a) == hash);
  CHECK(a->totals().frames == 11);
}

TEST_CASE(
    "the pull over the sphere has the same bits for the tree and brute force, and for each workgroup size") {
  GpuFixture fixture;
  std::string hash;
  std::uint64_t contacts = 0;
  std::uint32_t contact_hash = 0;
  for (const auto& [method, workgroup] :
       {std::pair{"bvh", 256U}, {"paper", 256U}, {"bvh", 64U}, {"bvh", 128U}, {"bvh", 256U}}) {
    CAPTURE(method);
    CAPTURE(workgroup);
    const scene::Scene scene =
        shipped_scene("pull-sphere", {{"cloths.0.grid", "[28,37]"}, {"contact.method", method}});
    auto world = world_of(fixture.device(), scene, {.workgroup_size = workgroup});
    advance(*world, 12);
    if (hash.empty()) {
      hash = hash_of(*world);
      contacts = world->totals().contacts;
      contact_hash = world->totals().contact_hash;
      CHECK(contacts > 0);
    }
    CHECK(hash_of(*world) == hash);
    CHECK(world->totals().contacts == contacts);
    CHECK(world->totals().contact_hash == contact_hash);
  }
}

TEST_CASE(
    "a node that is not finite freezes the state at the last good frame, within three frames of the host") {
  GpuFixture fixture;
  for (const float bad : {NAN, INFINITY, -INFINITY}) {
    auto world = world_of(fixture.device(), small_scene());
    advance(*world, 3);
    const std::string good = hash_of(*world);
    world->set_node(40, {0, bad, 0, 1}, {});
    Result<void> result;
    int frames = 0;
    while (result && frames < 10) {
      result = world->advance_frame();
      ++frames;
    }
    REQUIRE_FALSE(result);
    CHECK(frames <= 4);
    CHECK(result.error().kind == ErrorKind::Diverged);
    CHECK(result.error().message.find("In frame 3 ") != std::string::npos);
    const auto snapshot = world->snapshot();
    REQUIRE_OK(snapshot);
    CHECK(snapshot->hash() == good);
  }
}

TEST_CASE("a first frame that is not finite freezes the state at rest, and a reset thaws it") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), small_scene());
  const std::string rest = hash_of(*world);
  world->set_node(40, {0, NAN, 0, 1}, {});
  REQUIRE(world->advance_frame());
  CHECK(world->finish().error().kind == ErrorKind::Diverged);
  CHECK(world->finish().error().kind == ErrorKind::Diverged);  // the report is taken, the state still frozen
  const auto snapshot = world->snapshot();
  REQUIRE_OK(snapshot);
  CHECK(snapshot->hash() == rest);
  REQUIRE(world->reset());
  advance(*world, 2);
  CHECK(world->totals().nonfinite == 0);
}

TEST_CASE("a moved edge is where its motion says at the end of every frame") {
  GpuFixture fixture;
  auto parsed = scene::parse_scene(R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"},
          "contact": {"method": "none"}, "time": {"substeps": 5},
    "cloths": [{"grid": [5, 5], "size": [1, 1], "density": 1, "damping": 0,
    "stiffness": {"structural": 20, "shear": 10, "bend": 1},
    "motions": [{"nodes": "top", "kind": "line", "direction": [1, 0, 0], "speed": 0.6},
                {"nodes": "bottom", "kind": "rotation", "axis": [0, 1, 0], "center": [0, 0, 0], "speed": 2}]}]})",
                                   "moved.json");
  REQUIRE_OK(parsed);
  auto world = world_of(fixture.device(), *parsed);
  const auto start = world->snapshot();
  for (int frame = 1; frame <= 4; ++frame) {
    advance(*world, 1);
    const auto now = world->snapshot();
    REQUIRE_OK(now);
    const double time = frame / 60.0;
    for (std::size_t i = 0; i < 5; ++i) {
      CHECK(static_cast<double>(now->position[i].x) ==
            doctest::Approx(static_cast<double>(start->position[i].x) + 0.6 * time));
      CHECK(static_cast<double>(now->velocity[i].x) == doctest::Approx(0.6).epsilon(1e-3).scale(0));
      const Vec4f& before = start->position[20 + i];
      const Vec4f& after = now->position[20 + i];
      CHECK(static_cast<double>(after.x) ==
            doctest::Approx(static_cast<double>(before.x) * std::cos(2 * time)).epsilon(1e-5));
      CHECK(static_cast<double>(after.z) ==
            doctest::Approx(-static_cast<double>(before.x) * std::sin(2 * time)).epsilon(1e-4));
    }
  }
}

TEST_CASE("a sheet that falls on a plane and a sphere stays on their outer side") {
  GpuFixture fixture;
  auto parsed = scene::parse_scene(R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"},
          "contact": {"method": "bvh", "thickness": 0.01},
    "cloths": [{"grid": [20, 20], "size": [1, 1], "plane": "xz", "density": 0.3, "damping": 0.01,
    "transform": {"translate": [0, 0.55, 0]},
    "stiffness": {"structural": 100, "shear": 50, "bend": 5}}],
    "colliders": [{"kind": "sphere", "center": [0, 0.2, 0], "radius": 0.3},
    {"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}]})",
                                   "fall.json");
  REQUIRE_OK(parsed);
  auto world = world_of(fixture.device(), *parsed);
  advance(*world, 60);
  CHECK(world->totals().contacts > 0);
  const auto snapshot = world->snapshot();
  REQUIRE_OK(snapshot);
  for (const Vec4f& node : snapshot->position) {
    CHECK(node.y > 0);
    CHECK(length(node.xyz() - Vec3f{0, 0.2F, 0}) > 0.3F);
  }
  CHECK(world->totals().max_stretch < 1.5F);
}

TEST_CASE(
    "a scene too large for the adapter is refused before anything is simulated, with the limit's name") {
  GpuFixture fixture{OwnDevice{}};
  gpu::Limits limits = fixture.device().limits();
  limits.max_storage_binding_size = 1000;
  fixture.device().lower_limits(limits);
  const auto world = sim::World::create(fixture.device(), small_scene(), {.cloths = {{}}});
  REQUIRE_FALSE(world);
  CHECK(world.error().kind == ErrorKind::Limit);
  CHECK(world.error().message.find("maxStorageBufferBindingSize") != std::string::npos);
}

TEST_CASE("640,000 nodes fit in WebGPU's default limits in both formulations") {
  // Bytes of the largest bindings at 800 x 800 nodes, against the default of 128 MiB.
  const mesh::Grid grid{800, 800, 2, 2};
  const std::uint64_t limit = 128ULL << 20U;
  CHECK(mesh::grid_spring_count(grid) * sizeof(Spring) <= limit);
  CHECK(2 * mesh::grid_spring_count(grid) * 16 <= limit);
  CHECK(640000ULL * sizeof(Vec4f) <= limit);
}
