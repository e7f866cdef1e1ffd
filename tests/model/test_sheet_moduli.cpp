#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <optional>

#include "method/mass_spring/plan.hpp"
#include "model/sheet_moduli.hpp"
#include "scene/load.hpp"

using namespace weft;

namespace {

Model model_of(const std::string& cloth, const mesh::TriangleMesh& mesh = {}) {
  const auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "cloths": [{"density": 0.2, )" + cloth + "}]}", "test.json");
  REQUIRE_MESSAGE(scene, scene.error().message);
  auto model = build_model(*scene, {mesh});
  REQUIRE_MESSAGE(model, model.error().message);
  return std::move(*model);
}

/// Cells of 20 mm by 14 mm.
constexpr double kDx = 0.02, kDy = 0.014;
Model sheet(std::uint32_t cells_x, std::uint32_t cells_y, const std::string& stiffness) {
  return model_of(R"("grid": [)" + std::to_string(cells_x + 1) + ", " + std::to_string(cells_y + 1) +
                  R"(], "size": [)" + std::to_string(kDx * cells_x) + ", " + std::to_string(kDy * cells_y) +
                  R"(], "stiffness": )" + stiffness);
}

/// Small ways of a sheet's nodes in its plane, and what they take.
class Lattice {
 public:
  explicit Lattice(const Model& model)
      : model_(model), way_(2 * model.vertex_count()), given_(way_.size(), false) {}

  void give(std::size_t node, int axis, double way) {
    way_[2 * node + static_cast<std::size_t>(axis)] = way;
    given_[2 * node + static_cast<std::size_t>(axis)] = true;
  }
  double way(std::size_t node, int axis) const { return way_[2 * node + static_cast<std::size_t>(axis)]; }

  /// Lets go of what is not given, by conjugate gradients.
  void rest() {
    std::vector<double> residual = forces(way_), step = residual;
    double before = free_square(residual);
    const double wanted = 1e-24 * before;
    for (std::size_t n = 0; n < way_.size(); ++n)
      if (given_[n]) step[n] = 0;
    for (int k = 0; k < 100000 && before > wanted; ++k) {
      const std::vector<double> bent = forces(step);
      double along = 0;
      for (std::size_t n = 0; n < step.size(); ++n) along -= step[n] * bent[n];
      for (std::size_t n = 0; n < step.size(); ++n) {
        way_[n] += before / along * step[n];
        residual[n] += before / along * bent[n];
      }
      const double after = free_square(residual);
      for (std::size_t n = 0; n < step.size(); ++n)
        step[n] = given_[n] ? 0 : residual[n] + after / before * step[n];
      before = after;
    }
    REQUIRE(before <= wanted);
  }

  /// The force that holds a node's given way [N].
  double held(std::size_t node, int axis) const {
    return -forces(way_)[2 * node + static_cast<std::size_t>(axis)];
  }

 private:
  std::vector<double> forces(const std::vector<double>& way) const {
    std::vector<double> force(way.size());
    for (const Spring spring : model_.springs(model_.bodies[0])) {
      const std::size_t a = spring.node_a, b = spring.node_b;
      const Vec3d span = model_.rest_position[b] - model_.rest_position[a], n = span / length(span);
      const double pull = static_cast<double>(spring.stiffness) *
                          (n.x * (way[2 * b] - way[2 * a]) + n.y * (way[2 * b + 1] - way[2 * a + 1]));
      force[2 * a] += pull * n.x;
      force[2 * a + 1] += pull * n.y;
      force[2 * b] -= pull * n.x;
      force[2 * b + 1] -= pull * n.y;
    }
    return force;
  }
  double free_square(const std::vector<double>& x) const {
    double sum = 0;
    for (std::size_t n = 0; n < x.size(); ++n) sum += given_[n] ? 0 : x[n] * x[n];
    return sum;
  }

  const Model& model_;
  std::vector<double> way_;
  std::vector<bool> given_;
};

constexpr double kStrain = 1e-3;

struct Strip {
  double modulus, poisson;
};
/// A sheet that is pulled along i, its sides free: force per width by strain, and how it contracts half way.
Strip pulled(const Model& model) {
  const mesh::Grid& grid = *model.bodies[0].grid;
  Lattice lattice(model);
  for (std::uint32_t j = 0; j < grid.ny; ++j) {
    lattice.give(mesh::node_index(grid, 0, j), 0, 0);
    lattice.give(mesh::node_index(grid, grid.nx - 1, j), 0, kStrain * grid.width);
  }
  lattice.give(0, 1, 0);
  lattice.rest();
  double force = 0;
  for (std::uint32_t j = 0; j < grid.ny; ++j)
    force += lattice.held(mesh::node_index(grid, grid.nx - 1, j), 0);
  const double narrower = lattice.way(mesh::node_index(grid, grid.nx / 2, grid.ny - 1), 1) -
                          lattice.way(mesh::node_index(grid, grid.nx / 2, 0), 1);  // j runs down
  return {force / (grid.height * kStrain), narrower / (grid.height * kStrain)};
}

/// A wide sheet whose upper edge is moved along it, its sides free: force per width by angle.
double sheared(const Model& model) {
  const mesh::Grid& grid = *model.bodies[0].grid;
  Lattice lattice(model);
  for (std::uint32_t i = 0; i < grid.nx; ++i)
    for (const int axis : {0, 1}) {
      lattice.give(mesh::node_index(grid, i, grid.ny - 1), axis, 0);
      lattice.give(mesh::node_index(grid, i, 0), axis, axis == 0 ? kStrain * grid.height : 0);
    }
  lattice.rest();
  double force = 0;
  for (std::uint32_t i = 0; i < grid.nx; ++i) force += lattice.held(mesh::node_index(grid, i, 0), 0);
  return force / (grid.width * kStrain);
}

/// Boundary rows are one cell in n, so what they do falls as 1/n: the part that is left is known from two sizes.
void check_limit(const std::function<double(std::uint32_t)>& measured, double expected) {
  const double coarse = measured(12), fine = measured(24);
  CHECK(std::abs(fine - expected) <= 0.55 * std::abs(coarse - expected) + 1e-6 * std::abs(expected));
  CHECK(2 * fine - coarse == doctest::Approx(expected).epsilon(2e-3));  // 1/24² of itself
}

}  // namespace

TEST_CASE("a lattice without bend springs is the sheet that its moduli say, boundaries and all") {
  for (const char* stiffness : {R"({"structural": 500, "shear": 200, "bend": 0})",
                                R"({"structural": 100, "shear": 900, "bend": 0})"}) {
    const Model model = sheet(9, 7, stiffness);
    const Moduli moduli = sheet_moduli(model, model.bodies[0]).stretch;
    const Strip strip = pulled(model);
    CHECK(strip.modulus == doctest::Approx(moduli.warp).epsilon(1e-5));  // springs are stored in f32
    CHECK(strip.poisson == doctest::Approx(moduli.poisson).epsilon(1e-5));
  }
}

TEST_CASE("a lattice with bend springs tends to its moduli as it has more cells") {
  const auto size = [](std::uint32_t n) {
    return sheet(2 * n, n, R"({"structural": 500, "shear": 200, "bend": 60})");
  };
  const Model any = size(4);
  const Moduli moduli = sheet_moduli(any, any.bodies[0]).stretch;
  check_limit([&](std::uint32_t n) { return pulled(size(n)).modulus; }, moduli.warp);
  check_limit([&](std::uint32_t n) { return pulled(size(n)).poisson; }, moduli.poisson);
}

TEST_CASE("a lattice's modulus of shear is what a wide sheet resists with, but for its free sides") {
  const auto wide = [](std::uint32_t n) {
    return sheet(6 * n, 6, R"({"structural": 500, "shear": 200, "bend": 0})");
  };
  const Model any = wide(2);
  check_limit([&](std::uint32_t n) { return sheared(wide(n)); },
              sheet_moduli(any, any.bodies[0]).stretch.shear);
}

TEST_CASE("warp and weft of a lattice change places with its cells' sides") {
  const char* stiffness = R"("stiffness": {"structural": 500, "shear": 200, "bend": 60, "bending": 1e-5})";
  const Model wide = model_of(std::string(R"("grid": [9, 9], "size": [2, 1], )") + stiffness);
  const Model high = model_of(std::string(R"("grid": [9, 9], "size": [1, 2], )") + stiffness);
  const auto [a, a_bending] = sheet_moduli(wide, wide.bodies[0]);
  const auto [b, b_bending] = sheet_moduli(high, high.bodies[0]);
  CHECK(a.warp == doctest::Approx(b.weft));
  CHECK(a.weft == doctest::Approx(b.warp));
  CHECK(a.shear == doctest::Approx(b.shear));
  CHECK(a.poisson / a.warp == doctest::Approx(b.poisson / b.warp));  // one number of C's inverse
  CHECK(a_bending.warp == 1e-5);
  CHECK(a_bending.weft == 1e-5);
  CHECK(a_bending.shear == 0);  // rows and columns do not twist
}

TEST_CASE("without diagonals a lattice does not resist shear, and nothing is divided by 0") {
  const Model model = sheet(4, 4, R"({"structural": 500, "shear": 0, "bend": 0})");
  const Moduli moduli = sheet_moduli(model, model.bodies[0]).stretch;
  CHECK(moduli.warp == doctest::Approx(500 * kDx / kDy));
  CHECK(moduli.poisson == 0);
  CHECK(moduli.shear == 0);
  const Model none = sheet(4, 4, R"({"structural": 0, "shear": 0, "bend": 0})");
  CHECK(sheet_moduli(none, none.bodies[0]).stretch.warp == 0);
  CHECK(step_cause(none, none.bodies[0], 0).parts.empty());
}

TEST_CASE("a mesh of equilateral triangles has the moduli of the triangular lattice") {
  // E = 2 k / √3, ν = 1/3, G = √3 k / 4 (Ostoja-Starzewski 2002, Applied Mechanics Reviews 55(1), section 2).
  mesh::TriangleMesh mesh;
  constexpr std::uint32_t kSide = 8;
  for (std::uint32_t j = 0; j < kSide; ++j)
    for (std::uint32_t i = 0; i < kSide; ++i)
      mesh.positions.push_back(Vec3d{0.1 * (i + 0.5 * j), 0.1 * std::sqrt(0.75) * j, 0}.to<float>());
  for (std::uint32_t j = 0; j + 1 < kSide; ++j)
    for (std::uint32_t i = 0; i + 1 < kSide; ++i) {
      const std::uint32_t n = j * kSide + i;
      mesh.triangles.push_back({n, n + 1, n + kSide});
      mesh.triangles.push_back({n + 1, n + kSide + 1, n + kSide});
    }
  const Model model =
      model_of(R"("mesh": "a.obj", "stiffness": {"structural": 300, "shear": 300, "bend": 0})", mesh);
  const Moduli moduli = sheet_moduli(model, model.bodies[0]).stretch;
  CHECK(moduli.warp == doctest::Approx(600 / std::sqrt(3)).epsilon(1e-5));
  CHECK(moduli.weft == doctest::Approx(moduli.warp));
  CHECK(moduli.poisson == doctest::Approx(1.0 / 3));
  CHECK(moduli.shear == doctest::Approx(std::sqrt(3) / 4 * 300).epsilon(1e-5));
  CHECK(least_height(model, model.bodies[0]) == doctest::Approx(0.1 * std::sqrt(0.75)));
}

TEST_CASE(
    "the kind of element that bounds the explicit step is found, and never allows less than the whole") {
  const auto cause_of = [](const std::string& bending, double drag) {
    const Model model =
        model_of(R"("grid": [12, 9], "size": [0.22, 0.16], "fabric": {"warp": 2000, "weft": 1500,
                                    "shear": 60, "bending_warp": )" +
                 bending + "}");
    const StepCause cause = step_cause(model, model.bodies[0], drag);
    CHECK(cause.largest_step == mass_spring_step_limit(model, drag).largest_step);
    REQUIRE(cause.parts.size() == 2);
    CHECK(cause.parts[0].largest_step <= cause.parts[1].largest_step);
    // λ of a sum is at most the sum of both, and at least the greater: 1e-3 is what the estimates are good to.
    CHECK(cause.largest_step <= (1 + 1e-3) * cause.parts[0].largest_step);
    CHECK(cause.largest_step >= (1 - 1e-3) * cause.parts[0].largest_step / std::sqrt(2));
    return cause;
  };
  CHECK(cause_of("1e-5", 0).parts[0].kind == ElementKind::Membrane);
  CHECK(cause_of("10", 0).parts[0].kind == ElementKind::Hinge);
  CHECK(cause_of("1e-5", 100).largest_step < cause_of("1e-5", 0).largest_step);

  const Model springs = sheet(11, 8, R"({"structural": 500, "shear": 200, "bend": 60, "bending": 1e3})");
  const StepCause cause = step_cause(springs, springs.bodies[0], 0);
  REQUIRE(cause.parts.size() == 2);
  CHECK(cause.parts[0].kind == ElementKind::Triple);
  CHECK(cause.parts[1].kind == ElementKind::Spring);
}
