// The reference's energy of a whole sheet against its own derivatives, and under rigid motions.
#include <Eigen/Dense>

#include "element/hinge/angle_hessian.hpp"
#include "element/reference/sheet_matrix.hpp"
#include "reference_sheets.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

/// Symmetric differences over steps of ε^(1/3) of a length, where roundings and the third derivative are equally
/// small: both leave some ε^(2/3) = 4e-11 of the values' own size. The bound leaves 2500 for how much derivatives grow
/// from one to the next over a cell, and for what cancels.
const double kStep = 6e-6, kBound = 1e-7;

std::vector<Vec3d> with(std::vector<Vec3d> x, std::size_t coordinate, double way) {
  x[coordinate / 3][static_cast<int>(coordinate % 3)] += way;
  return x;
}

Sheet loaded_sheet(const PatternSheet& pattern, membrane::Energy energy) {
  Sheet sheet = cloth_of(pattern, energy);
  sheet.gravity = {1, -9.81, 2};
  sheet.load.assign(sheet.rest.size(), Vec3d{0.01, 0.02, -0.01});
  return sheet;
}

}  // namespace

TEST_CASE("the Hessian of an angle is the derivative of its slope, and symmetric") {
  Random random(5);
  for (int trial = 0; trial < 50; ++trial) {
    hinge::Corners x = {Vec3d{0, 0, 0}, {1, 0, 0}, {0.3, 0.8, 0}, {0.6, -0.7, 0}};
    for (Vec3d& corner : x) corner += random_vector(random, 0.25);
    const hinge::AngleHessian h = hinge::angle_hessian(x);
    for (std::size_t j = 0; j < 4; ++j)
      for (int axis = 0; axis < 3; ++axis) {
        hinge::Corners more = x, less = x;
        more[j][axis] += kStep;
        less[j][axis] -= kStep;
        const hinge::Corners up = hinge::angle_slope(more), down = hinge::angle_slope(less);
        for (std::size_t i = 0; i < 4; ++i) {
          const Vec3d change = (up[i] - down[i]) / (2 * kStep);
          const Vec3d column{h[i][j].x[axis], h[i][j].y[axis], h[i][j].z[axis]};
          const std::array rows = {h[j][i].x, h[j][i].y, h[j][i].z};
          CHECK(length(change - column) < kBound * (1 + length(column)));
          CHECK(length(column - rows[static_cast<std::size_t>(axis)]) < 1e-12 * (1 + length(column)));
        }
      }
  }
}

TEST_CASE("forces on a whole sheet are minus the slope of its energy") {
  for (const membrane::Energy energy : kEnergies)
    for (const Pattern kind : kPatterns) {
      const PatternSheet pattern = pattern_sheet(kind, 1, 4, 3);
      const SheetEnergy sheet(loaded_sheet(pattern, energy));
      const std::vector<Vec3d> x = crumpled(pattern, 2), force = sheet.forces(x);
      double largest = 0;
      for (const Vec3d& f : force) largest = std::max(largest, length(f));
      for (std::size_t k = 0; k < 3 * x.size(); ++k) {
        const double slope =
            (sheet.potential(with(x, k, kStep)) - sheet.potential(with(x, k, -kStep))) / (2 * kStep);
        CHECK(std::abs(slope + force[k / 3][static_cast<int>(k % 3)]) < kBound * largest);
      }
    }
}

TEST_CASE("the Hessian of a whole sheet is minus the derivative of its forces, and symmetric") {
  for (const membrane::Energy energy : kEnergies)
    for (const Pattern kind : kPatterns) {
      const PatternSheet pattern = pattern_sheet(kind, 1, 4, 3);
      const SheetEnergy sheet(loaded_sheet(pattern, energy));
      const Unknowns unknowns(sheet.sheet());
      const std::vector<Vec3d> x = crumpled(pattern, 2);
      const Eigen::MatrixXd h = SheetMatrix(sheet, unknowns).hessian(x, Curvature::Exact);
      const double largest = h.lpNorm<Eigen::Infinity>();
      CHECK((h - h.transpose()).lpNorm<Eigen::Infinity>() < 1e-13 * largest);
      for (std::size_t k = 0; k < 3 * x.size(); ++k) {
        const Eigen::VectorXd change = unknowns.gathered(sheet.forces(with(x, k, -kStep))) -
                                       unknowns.gathered(sheet.forces(with(x, k, kStep)));
        CHECK((change / (2 * kStep) - h.col(static_cast<int>(k))).lpNorm<Eigen::Infinity>() <
              kBound * largest);
      }
    }
}

TEST_CASE("the positive matrix is positive in every shape, and the Hessian itself in the shape at rest") {
  for (const membrane::Energy energy : kEnergies) {
    const PatternSheet pattern = pattern_sheet(Pattern::Irregular, 1, 4, 3);
    const SheetEnergy sheet(cloth_of(pattern, energy));
    const Unknowns unknowns(sheet.sheet());
    const SheetMatrix matrix(sheet, unknowns);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const Eigen::MatrixXd k = matrix.hessian(crumpled(pattern, seed), Curvature::Positive);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(k, Eigen::EigenvaluesOnly);
      CHECK(eigen.eigenvalues().minCoeff() > -1e-13 * eigen.eigenvalues().maxCoeff());
    }
    const Eigen::MatrixXd exact = matrix.hessian(pattern.position, Curvature::Exact),
                          positive = matrix.hessian(pattern.position, Curvature::Positive);
    CHECK((exact - positive).lpNorm<Eigen::Infinity>() < 1e-12 * exact.lpNorm<Eigen::Infinity>());
  }
}

TEST_CASE("a sheet that is moved and turned has the same energy, and its forces turn with it") {
  for (const membrane::Energy energy : kEnergies) {
    const PatternSheet pattern = pattern_sheet(Pattern::Irregular, 1, 5, 4);
    const SheetEnergy sheet(cloth_of(pattern, energy));
    const std::vector<Vec3d> x = crumpled(pattern, 4), force = sheet.forces(x);
    std::vector<Vec3d> moved;
    for (const Vec3d& p : x) moved.push_back(kTurn(p) + Vec3d{0.5, -2, 1});
    CHECK(sheet.potential(moved) == doctest::Approx(sheet.potential(x)).epsilon(1e-13));
    const std::vector<Vec3d> turned = sheet.forces(moved);
    Vec3d sum, torque;
    double largest = 0;
    for (std::size_t v = 0; v < x.size(); ++v) {
      sum += force[v];
      torque += cross(x[v], force[v]);
      largest = std::max(largest, length(force[v]));
    }
    for (std::size_t v = 0; v < x.size(); ++v) CHECK(length(turned[v] - kTurn(force[v])) < 1e-12 * largest);
    CHECK(length(sum) < 1e-12 * largest);
    CHECK(length(torque) < 1e-12 * largest);

    // To first order: moving it changes no force, turning it by w turns them by w.
    const Unknowns unknowns(sheet.sheet());
    const Matrix h = SheetMatrix(sheet, unknowns).hessian(x, Curvature::Exact);
    std::vector<Vec3d> shift(x.size(), Vec3d{1, 2, 3}), way, change;
    for (std::size_t v = 0; v < x.size(); ++v) {
      way.push_back(cross(kTurn.axis, x[v]));
      change.push_back(cross(kTurn.axis, force[v]));
    }
    const double scale = Eigen::MatrixXd(h).lpNorm<Eigen::Infinity>();
    CHECK((h * unknowns.gathered(shift)).lpNorm<Eigen::Infinity>() < 1e-12 * scale);
    CHECK((h * unknowns.gathered(way) + unknowns.gathered(change)).lpNorm<Eigen::Infinity>() < 1e-12 * scale);
  }
}
