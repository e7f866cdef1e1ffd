// A world that tears: by explicit and implicit steps, from saved bytes, for every workgroup size.
#include "contact_rig.hpp"
#include "method/method.hpp"
#include "model/cloth_size.hpp"
#include "scene/names.hpp"
#include "sim/mesh_change.hpp"

using namespace weft;

namespace {

constexpr double kWarp = 200, kStrength = 20, kLength = 0.24, kSpeed = 0.1;  // N/m, N/m, m, m/s

/// A strip between two clamps that go apart, beside nothing.
scene::Scene pulled_strip(const std::string& solver, bool pulled, const std::string& contact) {
  return contact_scene(R"("gravity": [0, 0, 0], "solver": {"kind": ")" + solver + R"("},
      "contact": {"method": ")" +
                       contact + R"(", "thickness": 0.004},
      "cloths": [{"grid": [13, 6], "size": [0.24, 0.1], "density": 0.1, "strength": 20, "pins": ["left"],
                  "fabric": {"warp": 200, "shear": 60, "bending_warp": 1e-5, "damping": 0.01},
                  "motions": [{"nodes": "right", "kind": "line", "direction": [1, 0, 0], "speed": )" +
                       (pulled ? "0.1" : "1e-9") + "}]}]");
}

/// Goes on by so many frames, and tears before each. The last world of the run.
std::unique_ptr<sim::World> torn_on(std::unique_ptr<sim::World> world, int frames) {
  for (int frame = 0; frame < frames; ++frame) {
    const auto changed = sim::change_mesh(world, "test");
    REQUIRE_OK(changed);
    advance(*world, 1);
  }
  return world;
}

}  // namespace

TEST_CASE(
    "a strip that is pulled slowly tears at the strain of its strength by its modulus, and unpulled never") {
  GpuFixture fixture;
  for (const std::string solver : {"mass_spring", "multigrid"}) {
    CAPTURE(solver);
    const double first = kStrength / kWarp * kLength / kSpeed * 60;  // frames, from rest
    auto world = torn_on(world_of(fixture.device(), pulled_strip(solver, true, "none")),
                         static_cast<int>(0.8 * first));
    CHECK(world->tears().splits() == 0);
    world = torn_on(std::move(world), static_cast<int>(0.4 * first));
    CHECK(world->tears().splits() > 0);
    world = torn_on(world_of(fixture.device(), pulled_strip(solver, false, "none")), 10);
    CHECK(world->tears().splits() == 0);
  }
}

TEST_CASE(
    "long: a torn world goes on from its bytes to the bits of one that never stopped, and refuses other "
    "tears") {
  GpuFixture fixture;
  for (const std::string solver : {"mass_spring", "multigrid"}) {
    CAPTURE(solver);
    auto world = torn_on(world_of(fixture.device(), pulled_strip(solver, true, "proximity")), 14);
    world = torn_on(std::move(world), 3);
    REQUIRE(world->tears().splits() > 0);
    const auto saved = world->save("test");
    REQUIRE_OK(saved);
    const auto read = sim::read_saved_state(sim::write_saved_state(*saved));
    REQUIRE_OK(read);
    CHECK(read->tears == saved->tears);
    auto whole = world_of(fixture.device(), pulled_strip(solver, true, "proximity"));
    CHECK_FALSE(whole->open(*read));
    sim::WorldOptions options{.workgroup_size = 64, .tears = read->tears};
    auto other = sim::World::create(fixture.device(), whole->scene(), whole->assets(), options);
    REQUIRE_OK(other);
    REQUIRE_OK((*other)->open(*read));
    const std::string ended = hash_of(*torn_on(std::move(world), 3));
    CHECK(hash_of(*torn_on(std::move(*other), 3)) == ended);
  }
}

TEST_CASE("long: the ball of scenes/torn-banner.json tears the banner where it flies, and gets through") {
  GpuFixture fixture;
  const Vec3d through{0.2, 0.05, 0};  // where the ball's middle crosses the banner's plane
  constexpr double kRadius = 0.22;
  auto world = world_of(fixture.device(), shipped_scene("torn-banner", {{"cloths.0.grid", "[41, 21]"}}));
  const std::vector<Vec3d> rest = world->model().host.rest_position;
  const std::vector<std::uint32_t> motion = world->model().host.motion;
  const auto size = [&] {
    const Model& model = world->model().host;
    return std::pair(mass_of(model, model.bodies[0]), area_of(model, model.bodies[0]));
  };
  const auto [mass, area] = size();
  world = torn_on(std::move(world), 26);  // it is 0.1 m away
  CHECK(world->tears().splits() == 0);
  world = torn_on(std::move(world), 34);  // it is 1.2 m beyond
  CHECK(world->tears().splits() > 10);
  CHECK(size().first == doctest::Approx(mass).epsilon(1e-6));
  CHECK(size().second == doctest::Approx(area).epsilon(1e-6));
  const auto now = world->snapshot();
  REQUIRE_OK(now);
  for (std::size_t i = 0; i < rest.size(); ++i)
    if (const Vec4f& x = now->position[i]; motion[i] != 0)  // at the poles
      CHECK(length(Vec3d{x.x, x.y, x.z} - rest[i]) < 1e-5);
  for (const std::uint32_t of : world->tears().cloths[0].origin)
    CHECK(length(rest[of] - through) < 3 * kRadius);
}
