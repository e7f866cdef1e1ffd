// The wind as a world keeps it: over frames, resets, and rest.
#include <cmath>

#include "world_rig.hpp"

using namespace weft;

namespace {

/// Root mean square of the nodes' speeds [m/s].
double speed_of(sim::World& world) {
  const auto snapshot = world.snapshot();
  REQUIRE_OK(snapshot);
  double sum = 0;
  for (const Vec4f& v : snapshot->velocity) sum += dot(v.xyz().to<double>(), v.xyz().to<double>());
  return std::sqrt(sum / static_cast<double>(snapshot->velocity.size()));
}

}  // namespace

TEST_CASE("a sheet in a breeze never comes to rest") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), shipped_scene("breeze", {{"cloths.0.grid", "[24,18]"}}));
  advance(*world, 600);
  double least = 1e9;
  for (int part = 0; part < 6; ++part) {
    advance(*world, 10);
    least = std::min(least, speed_of(*world));
  }
  CAPTURE(least);
  CHECK(least > 0.1);  // m/s; 0.32 was seen
  CHECK(world->totals().max_stretch < 1.2F);
}

TEST_CASE("gusts repeat bit for bit after a reset, and a wind of nothing changes no bit") {
  GpuFixture fixture;
  const std::vector<scene::Override> small = {{"cloths.0.grid", "[24,18]"}};
  auto gusty = world_of(fixture.device(), shipped_scene("breeze", small));
  advance(*gusty, 7);
  const std::string hash = hash_of(*gusty);
  REQUIRE(gusty->reset());
  advance(*gusty, 7);
  CHECK(hash_of(*gusty) == hash);

  const auto still_hash = [&](const std::string& wind) {
    auto overrides = small;
    overrides.push_back({"wind", wind});
    auto world = world_of(fixture.device(), shipped_scene("breeze", overrides));
    advance(*world, 7);
    return hash_of(*world);
  };
  CHECK(still_hash(R"({"gusts": 1, "wavelength": 0.2})") == still_hash("{}"));
  CHECK(still_hash("{}") != hash);
}
