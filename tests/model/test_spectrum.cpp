#include <doctest/doctest.h>

#include <cmath>

#include "base/random.hpp"
#include "method/mass_spring/plan.hpp"
#include "method/mass_spring/spectrum.hpp"
#include "scene/load.hpp"

using namespace weft;

namespace {

constexpr double kNodeMass = 0.25 * 0.02 * 0.02;  // [kg]

Model lattice(std::uint32_t nx, std::uint32_t ny, const std::string& stiffness) {
  const auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "cloths": [{"grid": [)" + std::to_string(nx) + ", " + std::to_string(ny) +
          R"(], "size": [)" + std::to_string(0.02 * (nx - 1)) + ", " + std::to_string(0.02 * (ny - 1)) +
          R"(], "density": 0.25, "damping": 0, "stiffness": )" + stiffness + "}]}",
      "test.json");
  REQUIRE_MESSAGE(scene, scene.error().message);
  auto model = build_model(*scene, std::vector<mesh::TriangleMesh>(1));
  REQUIRE_MESSAGE(model, model.error().message);
  return std::move(*model);
}

/// |A x| after many steps of power iteration on the same network: slow, and with nothing to get wrong.
double power_iteration(const SpringNetwork& network) {
  Random random(99);
  std::vector<Vec3d> x(network.position.size());
  for (Vec3d& v : x)
    for (int axis = 0; axis < 3; ++axis) v[axis] = random.uniform(-1, 1);
  double norm = 0;
  for (int i = 0; i < 20000; ++i) {
    std::vector<Vec3d> y(x.size());
    for (const Spring spring : Springs(network.springs)) {
      const Vec4f &a = network.position[spring.node_a], &b = network.position[spring.node_b];
      const Vec3d span = b.xyz().to<double>() - a.xyz().to<double>(), n = span / length(span);
      const double wa = std::sqrt(static_cast<double>(a.w)), wb = std::sqrt(static_cast<double>(b.w));
      const double pull = static_cast<double>(spring.stiffness) *
                          (wb * dot(n, x[spring.node_b]) - wa * dot(n, x[spring.node_a]));
      y[spring.node_b] += wb * pull * n;
      y[spring.node_a] -= wa * pull * n;
    }
    double squares = 0;
    for (const Vec3d& v : y) squares += dot(v, v);
    norm = std::sqrt(squares);
    for (std::size_t n = 0; n < x.size(); ++n) x[n] = y[n] / norm;
  }
  return norm;
}

}  // namespace

TEST_CASE("the highest frequency of lattices is found within 0.5 %, an edge mode above it included") {
  for (const auto& [nx, ny] : {std::pair{32U, 32U}, {50U, 21U}, {200U, 100U}}) {
    CAPTURE(nx);
    // Structural and shear springs: omega² = 4 (k + s) / m. A finite lattice lies below by (π / 2 n)² of it,
    // 0.6 % at 21 nodes; omega by half of that.
    const double plain =
        mass_spring_step_limit(lattice(nx, ny, R"({"structural": 500, "shear": 200, "bend": 0})"), 0)
            .highest_frequency;
    CHECK(plain == doctest::Approx(std::sqrt(4 * 700 / kNodeMass)).epsilon(0.005).scale(0));
    // All equal: the bend springs move the maximum off the alternating columns, to 10.125 k / m inside; a
    // free edge has a mode of its own 0.9 % above.
    const double equal =
        mass_spring_step_limit(lattice(nx, ny, R"({"structural": 300, "shear": 300, "bend": 300})"), 0)
            .highest_frequency;
    const double inside = std::sqrt(10.125 * 300 / kNodeMass);
    CHECK(equal > 0.998 * inside);
    CHECK(equal < 1.012 * inside);
  }
}

TEST_CASE("bending alone has omega² = 32 B / (a² m), where every second node of rows and columns is lifted") {
  const Model model = lattice(40, 50, R"({"structural": 0, "shear": 0, "bend": 0, "bending": 1e-3})");
  const double expected = 32 * 1e-3 / (0.02 * 0.02 * kNodeMass);
  const double found = mass_spring_step_limit(model, 0).highest_frequency;
  CHECK(found * found ==
        doctest::Approx(expected).epsilon(0.01).scale(0));  // (π / 2 n)² of a finite lattice, n = 40: 0.3 %
}

TEST_CASE("the largest eigenvalue of random networks is that of a long power iteration") {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    Random random(seed);
    SpringNetwork network;
    const std::uint32_t nodes = 2 + random.below(30);
    for (std::uint32_t n = 0; n < nodes; ++n)
      network.position.push_back(
          Vec4f::from(Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}.to<float>(),
                      static_cast<float>(random.uniform(0.1, 20))));
    for (std::uint32_t s = 0; s < 4 * nodes; ++s) {
      const std::uint32_t a = random.below(nodes), b = random.below(nodes);
      if (a != b) append(network.springs, {a, b, 0, static_cast<float>(random.uniform(1, 1000)), 0});
    }
    if (network.springs.size() == 0) continue;
    CAPTURE(seed);
    const double expected = power_iteration(network), found = find_spectrum(network).stiffness;
    CHECK(found == doctest::Approx(expected).epsilon(1e-3).scale(0));
    CHECK(find_spectrum(network).damping == 0);
  }
}

TEST_CASE("one spring between two nodes has the frequency of its reduced mass") {
  SpringNetwork network;
  network.position = {{0, 0, 0, 2}, {0, 3, 0, 6}};  // w: 1/kg
  append(network.springs, {0, 1, 3, 50, 0.5F});
  CHECK(find_spectrum(network).stiffness == doctest::Approx(50 * 8));
  CHECK(find_spectrum(network).damping == doctest::Approx(0.5 * 8));
}

TEST_CASE("damping lowers the limit to 4 / (√(μ² + 4 λ) + μ), and a system without springs has none") {
  CHECK(largest_stable_step(4, 0) == doctest::Approx(1));
  CHECK(largest_stable_step(4, 3) == doctest::Approx(0.5));  // (5 - 3) / 4
  CHECK(largest_stable_step(0, 0) == 0);
  CHECK(largest_stable_step(0, 4) == doctest::Approx(0.5));
  CHECK(find_spectrum({}).stiffness == 0);
}

TEST_CASE("a limit stays one, however strong the damping") {
  for (const double damping : {1e6, 1e9, 1e12, 1e18})  // far above √(4 λ) = 200: 2/μ is left
    CHECK(largest_stable_step(1e4, damping) == doctest::Approx(2 / damping));
}

TEST_CASE("an unstable step is said with both steps and both numbers of substeps, a stable one is not") {
  StepLimit limit;
  CHECK(unstable_step(limit, 0.5, 1).empty());  // there is no limit
  limit.largest_step = 0.1;
  CHECK(unstable_step(limit, 0.5, 5).empty());
  CHECK(unstable_step(limit, 0.5, 2) ==
        "The step of 250 ms is longer than the largest stable one of 100 ms, so the cloth may blow up: "
        "5 substeps a frame are needed, not 2.");
}

TEST_CASE("substeps are rounded up to a multiple of 4, and too many are refused with both numbers") {
  const scene::Scene scene;  // 60 frames a second
  StepLimit limit;
  limit.largest_step = scene.time.frame / 5;
  const auto substeps = stable_substeps(scene, limit);
  REQUIRE_MESSAGE(substeps, substeps.error().message);
  CHECK(*substeps == 8);  // 5 / 0.7 = 7.1
  limit.largest_step = 1e-9;
  const auto refused = stable_substeps(scene, limit);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().kind == ErrorKind::Limit);
  CHECK(refused.error().message.find("65536") != std::string::npos);
}
