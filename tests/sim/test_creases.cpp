// What cloth keeps of its bends is part of a world's state: repeated, diverged, reset and restored.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "contact_rig.hpp"

using namespace weft;

namespace {

/// A sheet of paper that falls over a ball, and keeps bends of more than 0.12 rad a cell.
scene::Scene falling_paper(const std::string& solver) {
  return contact_scene(R"("time": {"substeps": 9}, "solver": {"kind": ")" + solver + R"("},
      "contact": {"method": "proximity", "thickness": 0.01},
      "cloths": [{"grid": [11, 9], "size": [0.4, 0.3], "plane": "xz", "density": 0.2,
                  "transform": {"translate": [0, 0.125, 0]},
                  "fabric": {"warp": 40, "shear": 12, "bending_warp": 1e-4, "plastic": {"yield_curvature": 3}}}],
      "colliders": [{"kind": "sphere", "center": [0.02, 0, 0.01], "radius": 0.1}])");
}

std::vector<Vec4f> creases_of(sim::World& world) {
  const auto snapshot = world.snapshot();
  REQUIRE_OK(snapshot);
  return snapshot->creases;
}
bool same(const std::vector<Vec4f>& a, const std::vector<Vec4f>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec4f)) == 0;
}
bool any(const std::vector<Vec4f>& creases) {
  return std::any_of(creases.begin(), creases.end(), [](const Vec4f& crease) { return crease.w > 0; });
}

constexpr int kFrames = 12;

}  // namespace

TEST_CASE("frames that are run again begin with the creases that they began with") {
  GpuFixture fixture;
  for (const std::string solver : {"mass_spring", "multigrid"}) {
    CAPTURE(solver);
    auto roomy = world_of(fixture.device(), falling_paper(solver));
    advance(*roomy, kFrames);
    auto tight = world_of(fixture.device(), falling_paper(solver), {.contact_room = ContactRoom{8, 8, 8}});
    advance(*tight, kFrames);
    CHECK(tight->totals().repeated_frames > 0);
    CHECK(hash_of(*tight) == hash_of(*roomy));
    CHECK(any(creases_of(*roomy)));
    CHECK(same(creases_of(*tight), creases_of(*roomy)));
  }
}

TEST_CASE(
    "a world that diverges keeps its last good creases, a reset has none, and a snapshot brings its own") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), falling_paper("multigrid"));
  CHECK_FALSE(any(creases_of(*world)));
  advance(*world, kFrames);
  const auto good = world->snapshot();
  REQUIRE_OK(good);
  const std::vector<Vec4f> kept = creases_of(*world);
  advance(*world, 2);
  const std::string further = hash_of(*world);
  CHECK_FALSE(same(creases_of(*world), kept));
  const std::vector<Vec4f> last = creases_of(*world);
  world->set_node(40, {0, NAN, 0, 1}, {});
  REQUIRE(world->advance_frame());
  CHECK(world->finish().error().kind == ErrorKind::Diverged);
  CHECK(same(creases_of(*world), last));
  REQUIRE(world->reset());
  CHECK_FALSE(any(creases_of(*world)));
  advance(*world, kFrames);
  CHECK(same(creases_of(*world), kept));
  REQUIRE(world->reset());
  REQUIRE(world->restore(*good));
  CHECK(same(creases_of(*world), kept));
  advance(*world, 2);
  CHECK(hash_of(*world) == further);
}

TEST_CASE("a snapshot of other cloth is refused by the facets that keep bends") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), falling_paper("multigrid"));
  scene::Scene elastic = falling_paper("multigrid");
  elastic.cloths[0].fabric->plastic.reset();
  auto other = world_of(fixture.device(), elastic);
  const auto snapshot = world->snapshot();
  REQUIRE_OK(snapshot);
  const auto refused = other->restore(*snapshot);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message == "The snapshot has 160 facets that keep bends; this scene has 0.");
}
