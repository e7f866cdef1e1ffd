#include <doctest/doctest.h>

#include <cmath>

#include "element/spring/law.hpp"
#include "model/cords.hpp"
#include "model/limited_edges.hpp"
#include "scene/load.hpp"

using namespace weft;

namespace {

Model model_of(const std::string& cloth, const mesh::TriangleMesh& mesh = {}) {
  const auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "cloths": [{"density": 0.2,
      "strain_limit": 0.1, )" + cloth + "}]}",
                                        "test.json");
  REQUIRE_MESSAGE(scene, scene.error().message);
  auto model = build_model(*scene, {mesh});
  REQUIRE_MESSAGE(model, model.error().message);
  return std::move(*model);
}

}  // namespace

TEST_CASE(
    "limited edges of a grid of fabric resist as the strips of cloth beside them, half of them at its rim") {
  constexpr double kAlong = 0.02, kAcross = 0.03, kWarp = 900, kWeft = 300;
  const Model model = model_of(R"("grid": [6, 5], "size": [0.1, 0.12], "pins": [{"nodes": [0, 1]}],
      "fabric": {"warp": 900, "weft": 300, "shear": 60, "poisson": 0.3, "bending_warp": 1e-5})");
  const std::vector<Cord> springs = limit_cords(model, model.bodies[0]);
  REQUIRE(springs.size() == 5 * 5 + 6 * 4 - 1);  // without diagonals, and the edge between the pins
  for (const Cord& s : springs) {
    const bool along = s.b == s.a + 1;
    const bool rim = along ? s.a < 6 || s.a >= 24 : s.a % 6 == 0 || s.a % 6 == 5;
    const double width = (along ? kAcross : kAlong) * (rim ? 0.5 : 1);
    const double length = along ? kAlong : kAcross;
    CHECK(s.longest == doctest::Approx(1.1 * length));
    CHECK(s.stiffness == doctest::Approx(spring::kStiffer * (along ? kWarp : kWeft) * width / length));
  }
}

TEST_CASE("limited edges of equilateral triangles of isotropic fabric have its Young's modulus, times 50") {
  constexpr double kSide = 0.01, kYoung = 500;
  mesh::TriangleMesh mesh;
  const auto node = [](std::uint32_t i, std::uint32_t j) { return j * 9 + i; };
  for (std::uint32_t j = 0; j < 8; ++j)
    for (std::uint32_t i = 0; i < 9; ++i)
      mesh.positions.push_back(Vec3d{kSide * (i + 0.5 * j), kSide * std::sqrt(0.75) * j, 0}.to<float>());
  for (std::uint32_t j = 0; j + 1 < 8; ++j)
    for (std::uint32_t i = 0; i + 1 < 9; ++i) {
      mesh.triangles.push_back({node(i, j), node(i + 1, j), node(i, j + 1)});
      mesh.triangles.push_back({node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
    }
  const Model model =
      model_of(R"("mesh": "a.obj", "fabric": {"energy": "neo_hookean", "warp": 500, "shear": 200,
      "poisson": 0.25, "bending_warp": 1e-5})",
               mesh);
  double sum = 0, turned = 0, both = 0;
  for (const Cord& s : limit_cords(model, model.bodies[0])) {
    const Vec3d span = model.rest_position[s.b] - model.rest_position[s.a];
    const double each = s.stiffness / dot(span, span);
    sum += each * std::pow(span.x, 4);
    turned += each * std::pow(span.y, 4);
    both += each * span.x * span.x * span.y * span.y;
  }
  const double area = 2 * 7 * 8 * kSide * kSide * std::sqrt(0.75) / 2;
  // Equation 21 of docs/elements.md; ν is 1/3, so that C11 is E / (1 - ν²).
  CHECK(sum / (spring::kStiffer * area) == doctest::Approx(9.0 / 8 * kYoung).epsilon(1e-5));
  CHECK(turned / (spring::kStiffer * area) == doctest::Approx(9.0 / 8 * kYoung).epsilon(1e-5));
  CHECK(both / (spring::kStiffer * area) == doctest::Approx(3.0 / 8 * kYoung).epsilon(1e-5));
}

TEST_CASE("the modulus along a direction is that of the compliance, turned there") {
  const Moduli m{900, 300, 0.25, 60};
  CHECK(modulus_along(m, 2, 0) == doctest::Approx(900));
  CHECK(modulus_along(m, 0, -3) == doctest::Approx(300));
  CHECK(modulus_along(m, 1, 1) == doctest::Approx(4 / (1.0 / 900 + 1.0 / 300 - 2 * 0.25 / 900 + 1.0 / 60)));
  const Moduli same = Moduli::isotropic(700, 0.3);
  for (const double angle : {0.1, 0.7, 1.3, 2.5})
    CHECK(modulus_along(same, std::cos(angle), std::sin(angle)) == doctest::Approx(700));
}
