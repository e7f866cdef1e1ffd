// The paper's second experiment on its three objects: the cloth does not pass through.
#include <cmath>
#include <cstdio>

#include "reference/collision/winding.hpp"
#include "world_rig.hpp"

using namespace weft;

namespace {

void check_pull(const std::string& object, std::uint32_t side) {
  GpuFixture fixture;
  const std::string count = std::to_string(side);
  const scene::Scene scene = shipped_scene("pull-" + object, {{"cloths.0.grid", "[" + count + "," + count + "]"}});
  auto world = world_of(fixture.device(), scene);
  advance(*world, 2);
  CHECK_MESSAGE(world->totals().contacts > 0, "the sheet touches the object within two frames");
  advance(*world, scene.time.frames - 2);
  const auto snapshot = world->snapshot();
  REQUIRE_OK(snapshot);
  const mesh::Bounds box = mesh::bounds(world->assets().objects[0]);
  const auto in_box = [&](const Vec3f& p) { return max(p, box.low) == p && min(p, box.high) == p; };
  std::size_t inside = 0;
  for (const Vec4f& node : snapshot->position)
    if (in_box(node.xyz())) inside += reference::inside(node.xyz().to<double>(), world->assets().objects[0]) ? 1 : 0;
  MESSAGE(object, " ", side, "²: ", world->substeps(), " substeps, ", world->totals().contacts, " hits, stretch ",
          world->totals().max_stretch, ", inside ", inside);
  CHECK(inside == 0);
  CHECK(world->totals().max_stretch <= 1.5F);
  CHECK(world->totals().contact_overflow == 0);
}

}  // namespace

TEST_CASE("no node of a sheet of 48² ends inside the sphere it is pulled over") { check_pull("sphere", 48); }
TEST_CASE("no node of a sheet of 48² ends inside the armadillo it is pulled over") { check_pull("armadillo", 48); }
TEST_CASE("no node of a sheet of 48² ends inside the dragon it is pulled over") { check_pull("dragon", 48); }
TEST_CASE("long: no node of a sheet of 64² and 100² ends inside the sphere") { check_pull("sphere", 64), check_pull("sphere", 100); }
TEST_CASE("long: no node of a sheet of 64² and 100² ends inside the armadillo") { check_pull("armadillo", 64), check_pull("armadillo", 100); }
TEST_CASE("long: no node of a sheet of 64² and 100² ends inside the dragon") { check_pull("dragon", 64), check_pull("dragon", 100); }
