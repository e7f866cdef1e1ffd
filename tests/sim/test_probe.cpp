// What a probe says of a node, by statics and by the world's own state.
#include <cmath>

#include "contact_rig.hpp"
#include "reference/simulation.hpp"
#include "sim/probe.hpp"

using namespace weft;

namespace {

constexpr double kDensity = 0.4, kStripLength = 0.6;  // kg/m², m
constexpr std::uint32_t kColumns = 5, kRows = 16;

Result<sim::Probe> probe_of(const sim::World& world, std::uint32_t node) {
  WEFT_TRY(state, world.node_state());
  return sim::probe(world.model().host, state, node);
}

/// A strip that hangs by its upper edge, with much drag.
scene::Scene hanging_strip(const std::string& solver, const std::string& material) {
  return contact_scene(R"("drag": 6, "solver": {"kind": ")" + solver + R"("}, "contact": {"method": "none"},
      "cloths": [{"grid": [5, 16], "size": [0.12, 0.6], "density": 0.4, "pins": ["top"], )" +
                       material + "}]");
}

}  // namespace

TEST_CASE("each row of a strip bears the weight of what hangs below it, by its width") {
  GpuFixture fixture;
  const std::string springs = R"("stiffness": {"structural": 400, "shear": 0, "bend": 0}, "damping": 0.02)";
  const std::string fabric =
      R"("fabric": {"warp": 400, "weft": 300, "shear": 60, "poisson": 0, "bending_warp": 1e-6, "damping": 0.01})";
  for (const std::string& material : {springs, springs + R"(, "strength": 1000)", fabric})
    for (const std::string solver : {"mass_spring", "multigrid"}) {
      CAPTURE(solver);
      CAPTURE(material);
      auto world = world_of(fixture.device(), hanging_strip(solver, material));
      advance(*world, 90);
      for (const std::uint32_t row : {3U, 8U, 12U}) {  // from the top
        const auto found = probe_of(*world, row * kColumns + kColumns / 2);
        REQUIRE_OK(found);
        const double below = kStripLength * (kRows - 1 - row) / (kRows - 1);
        CAPTURE(row);
        CHECK(found->tension == doctest::Approx(kDensity * kGravity * below).epsilon(0.03));
        CHECK(length(found->velocity) < 1e-3);
        // The edges that bear are those above and below.
        CHECK(found->stretch == doctest::Approx(1 + kDensity * kGravity * below / 400).epsilon(0.01));
      }
    }
}

TEST_CASE("pins hold a hanging sheet with its weight, and on its free nodes the forces are in balance") {
  GpuFixture fixture;
  const std::string springs = R"("pins": ["top_left", "top_right"], "damping": 0.02,
      "stiffness": {"structural": 400, "shear": 100, "bend": 2})";
  const std::string fabric =
      R"("pins": ["top"], "fabric": {"warp": 400, "weft": 300, "shear": 60, "bending_warp": 1e-6, "damping": 0.01})";
  for (const std::string& cloth : {springs, fabric})
    for (const std::string solver : {"mass_spring", "multigrid"}) {
      CAPTURE(solver);
      CAPTURE(cloth);
      auto world = world_of(fixture.device(), contact_scene(R"("drag": 6, "solver": {"kind": ")" + solver +
                                                            R"("}, "contact": {"method": "none"},
              "cloths": [{"grid": [12, 16], "size": [0.3, 0.4], "density": 0.4, )" +
                                                            cloth + "}]"));
      REQUIRE_OK(world->grab(12 * 16 - 1, world->model().host.rest_position[12 * 16 - 1]));  // and a hand
      advance(*world, 150);
      const Model& model = world->model().host;
      const auto now = world->node_state();
      REQUIRE_OK(now);
      auto elements = reference::elements_of(model);
      const Vec3d gravity = world->scene().gravity;
      const std::vector<Vec3d> forces =
          reference::forces_at(elements, now->position, now->velocity, now->creases, model.mass, gravity);
      Vec3d held, free;
      double weight = 0;
      for (std::uint32_t node = 0; node < model.vertex_count(); ++node) {
        (model.kinematic(node) || node == 12 * 16 - 1 ? held : free) += forces[node];
        weight += kGravity * model.mass[node];
      }
      CHECK(length(held - Vec3d{0, -weight, 0}) < 0.03 * weight);
      CHECK(length(free) < 0.03 * weight);
    }
}

TEST_CASE(
    "a probe says where a node is, where it was at rest, how fast it is, and refuses one that is none") {
  GpuFixture fixture;
  auto world =
      world_of(fixture.device(),
               hanging_strip("mass_spring",
                             R"("stiffness": {"structural": 4, "shear": 1, "bend": 0.1}, "damping": 0)"));
  advance(*world, 3);
  const auto now = world->snapshot();
  REQUIRE_OK(now);
  for (const std::uint32_t node : {0U, 42U, kColumns * kRows - 1}) {
    const auto found = probe_of(*world, node);
    REQUIRE_OK(found);
    const Vec4f &x = now->position[node], &v = now->velocity[node];
    CHECK(found->position == Vec3d{x.x, x.y, x.z});
    CHECK(found->velocity == Vec3d{v.x, v.y, v.z});
    CHECK(found->rest == world->model().host.rest_position[node]);
    CHECK(found->mass == world->model().host.mass[node]);
  }
  const auto none = probe_of(*world, kColumns * kRows);
  REQUIRE_FALSE(none);
  CHECK(none.error().kind == ErrorKind::Input);
  CHECK(none.error().message == "There is no node 80; there are 80, from 0.");
}
