// Which cloths may enclose a gas, and what it is then.
#include "model/enclosed.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "gas_balls.hpp"
#include "method/method.hpp"
#include "scene/load.hpp"

using namespace weft;

namespace {

Result<Model> model_of(const mesh::TriangleMesh& mesh, const std::string& pressure = R"({"gauge": 500})") {
  const auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "cloths": [{"mesh": "ball.ply", "density": 0.2, "pressure": )" +
          pressure + "}]}",
      "a.json");
  REQUIRE_MESSAGE(static_cast<bool>(scene), scene.error().message);
  return build_model(*scene, {mesh});
}

std::string refusal_of(const mesh::TriangleMesh& mesh, const std::string& pressure = R"({"gauge": 500})") {
  const auto model = model_of(mesh, pressure);
  REQUIRE(!model);
  CHECK(model.error().kind == ErrorKind::Input);
  return model.error().message;
}

/// Two sheets of a quarter of a metre that are sewn together at their rims: four triangles, nothing between them.
mesh::TriangleMesh pillow() {
  return {{{0, 0, 0}, {0.5F, 0, 0}, {0.5F, 0.5F, 0}, {0, 0.5F, 0}},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

}  // namespace

TEST_CASE("a ball's gas begins at the volume inside its triangles, wherever it is") {
  for (const Vec3d& center : {Vec3d{}, Vec3d{1000, 2000, -500}}) {
    const auto model = model_of(ball(12, center));
    REQUIRE(model);
    const gas::Law& gas = *model->bodies[0].gas;
    // Flat triangles between points of a sphere: by Taylor, less by some 1/(cells²).
    CHECK(gas.rest_volume == doctest::Approx(4.0 / 3 * 3.14159265358979 * 0.027).epsilon(0.02));
    CHECK(gas.rest_gauge == 500);
    CHECK(gas.rest_pressure == 101825);
    CHECK(gas.gauge(gas.rest_volume) == 500);
    CHECK(gas.gauge(gas.rest_volume / 2) == doctest::Approx(2 * 101825 - 101325).epsilon(1e-14));
    CHECK(gas.energy(gas.rest_volume) == 0);
  }
}

TEST_CASE("what is not closed, or turned, or has no inside, is refused with what is wrong") {
  mesh::TriangleMesh open = ball(3);
  open.triangles.pop_back();
  CHECK(refusal_of(open) ==
        "a.json: cloths[0].pressure needs a closed mesh; 3 of the 270 edges of \"ball.ply\" have not two "
        "triangles.");
  mesh::TriangleMesh turned = ball(3);
  std::swap(turned.triangles[7][0], turned.triangles[7][1]);
  CHECK(refusal_of(turned) ==
        "a.json: cloths[0].pressure needs triangles that all face outward; at 3 of the 270 edges of "
        "\"ball.ply\" "
        "two turn against each other.");
  mesh::TriangleMesh inward = ball(3);
  for (mesh::Triangle& triangle : inward.triangles) std::swap(triangle[0], triangle[1]);
  CHECK(refusal_of(inward).find(
            "cloths[0].pressure needs triangles that all face outward; those of \"ball.ply\" "
            "face inward, around 0.1") != std::string::npos);
  mesh::TriangleMesh twice = ball(2);
  twice.triangles.insert(twice.triangles.end(), twice.triangles.begin(), twice.triangles.end());
  CHECK(refusal_of(twice).find("120 of the 120 edges") != std::string::npos);
}

TEST_CASE(
    "two sheets sewn at their rims have no volume for a gas, but may be blown up by a constant pressure") {
  CHECK(refusal_of(pillow()).find(
            "pressure.law is \"isothermal\", and \"ball.ply\" encloses only 0 m³ at rest") !=
        std::string::npos);
  const auto model = model_of(pillow(), R"({"gauge": 200, "law": "constant"})");
  REQUIRE(model);
  CHECK(model->bodies[0].gas->gauge(0) == 200);
  CHECK(model->bodies[0].gas->gauge(1) == 200);
  CHECK(model->bodies[0].gas->energy(0.5) == -100);
}

TEST_CASE(
    "a volume below a hundredth of that at rest counts as that, and the energy goes on with that pressure") {
  const gas::Law gas{2, 1000, 100};
  CHECK(gas.gauge(0.02) == gas.gauge(-1));
  CHECK(gas.energy(0.01) - gas.energy(0.02) == doctest::Approx(0.01 * gas.gauge(0.02)).epsilon(1e-10));
}

TEST_CASE("where no method is stable in the steps that a scene asks for, the one is taken that needs least") {
  const auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "time": {"substeps": 1}, )" +
                                            ball_scene(R"({"kind": "auto"})", kDust, R"({"gauge": 0})") + "}",
                                        "a.json");
  REQUIRE_MESSAGE(static_cast<bool>(scene), scene.error().message);
  const auto model = build_model(*scene, {ball(3)});
  REQUIRE(model);
  const auto choice = choose_method(*scene, *model);
  REQUIRE(choice);
  CHECK(choice->method->kind == scene::SolverKind::MassSpring);  // 2/√λ, where multigrid has 2/√(3 λ)
  CHECK(choice->substeps == 1);
  CHECK(unstable_step(choice->limit, scene->time.frame, 1).find("so the cloth may blow up") !=
        std::string::npos);
}
