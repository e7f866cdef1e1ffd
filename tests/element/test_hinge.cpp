// Angles at edges against their own derivatives, and bending of sheets against even curvature.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "closed_forms/pattern_sheet.hpp"
#include "element/hinge/law.hpp"
#include "element/hinge/plate.hpp"
#include "rolled_sheet.hpp"

using namespace weft;
using namespace weft::hinge;

namespace {

Vec3d random_vector(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

/// Two triangles about a unit edge, at an angle.
Corners folded(double angle) {
  return {Vec3d{0, 0, 0}, {1, 0, 0}, {0.3, 0.8, 0}, {0.6, -0.7 * std::cos(angle), 0.7 * std::sin(angle)}};
}

PatternSheet stretched(PatternSheet sheet, double aspect) {
  sheet.width *= aspect;
  for (Vec3d& p : sheet.position) p.y *= aspect;
  return sheet;
}

/// The bending moment of a curvature (K11, K22, 2 K12).
Vec3d moment_of(const Stiffness& d, const Vec3d& k) {
  return {d.warp * k.x + d.coupled * k.y, d.coupled * k.x + d.weft * k.y, d.shear * k.z};
}

const Stiffness kOrthotropic = Stiffness::of({9e-5, 2e-5, 0.3, 1.5e-5});

/// The strain energy of a cylinder by its curvature, whose direction is at an angle to warp, per area and k²/2.
double cylinder_modulus(const Stiffness& d, double direction) {
  const double c = std::cos(direction), s = std::sin(direction);
  const Vec3d k{c * c, s * s, 2 * c * s};
  return dot(k, moment_of(d, k));
}

/// The energy of inner facets of a sheet that is at rest in one shape and held in another, a cylinder and a plane, by
/// that of a cylinder of their area.
double cylinder_ratio(const PatternSheet& sheet, const Stiffness& d, double curvature, double direction,
                      const std::vector<Vec3d>& rest, const std::vector<Vec3d>& x) {
  Plate plate = build_plate({rest, sheet.triangles}, d);
  double area = 0;
  for (std::size_t t = 0; t < plate.facets.size(); ++t) {
    const auto& nodes = sheet.triangles[t];
    const bool inner = std::all_of(nodes.begin(), nodes.end(),
                                   [&](std::uint32_t v) { return sheet.inside(v, 2.5 * sheet.cell); });
    if (inner)
      area += sheet.area_of(t);
    else
      plate.facets[t].stiffness = {};
  }
  REQUIRE(area > 0);
  const double exact = area * cylinder_modulus(d, direction) * curvature * curvature / 2;
  return energy(plate, bends(plate, x)) / exact;
}

}  // namespace

TEST_CASE("the angle of a hinge is that by which it was folded, either way, up to half a turn") {
  for (int degrees = -179; degrees <= 179; degrees += 2) {
    const double fold = degrees * std::acos(-1.0) / 180;
    CHECK(angle(folded(fold)) == doctest::Approx(fold).epsilon(1e-12).scale(0));
    // Swapping the triangles, and the edge's ends with them, is the same hinge.
    const auto [a, b, c, d] = folded(fold);
    CHECK(angle({b, a, d, c}) == doctest::Approx(fold).epsilon(1e-12).scale(0));
  }
}

TEST_CASE("the slope of a hinge's angle is its change; its forces neither push nor turn") {
  Random random(1);
  for (int sample = 0; sample < 500; ++sample) {
    Corners x = folded(random.uniform(-3, 3)), way;
    for (Vec3d& p : x) p += random_vector(random, 0.2);
    for (Vec3d& w : way) w = random_vector(random, 1);
    const Corners slope = angle_slope(x);
    const double h = 1e-6;
    Corners after = x, before = x;
    double expected = 0, size = 0;
    Vec3d sum, turn;
    for (std::size_t i = 0; i < 4; ++i) {
      after[i] += h * way[i];
      before[i] -= h * way[i];
      expected += dot(slope[i], way[i]);
      sum += slope[i];
      turn += cross(x[i], slope[i]);
      size += length(slope[i]);
    }
    const double change = std::remainder(angle(after) - angle(before), 2 * std::acos(-1.0)) / (2 * h);
    CHECK(std::abs(change - expected) <
          1e-7 * size * size * size);  // third derivatives times h², and roundings
    CHECK(length(sum) < 1e-13 * size);
    CHECK(length(turn) < 1e-13 * size);
  }
}

TEST_CASE("on a sheet of even curvature every inner hinge has the moment of the plate, and no node a force") {
  // The patch test of bending. Curvature is so small that the angles are linear in it.
  for (const Pattern pattern : kPatterns)
    for (const double aspect : {1.0, 5.0})
      for (const Vec3d& k : {Vec3d{1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {0.4, -0.7, 1.1}}) {
        CAPTURE(name_of(pattern));
        const PatternSheet sheet = stretched(pattern_sheet(pattern, 1, 12, 12), aspect);
        const Plate plate = build_plate({sheet.position, sheet.triangles}, kOrthotropic);
        const double small = 1e-5 / (aspect * aspect);
        std::vector<Vec3d> x = sheet.position, force(x.size());
        for (Vec3d& p : x) p.z = small * (k.x * p.x * p.x + k.y * p.y * p.y + k.z * p.x * p.y) / 2;
        const std::vector<double> m = moments(plate, bends(plate, x));
        add_forces(plate, m, x, force);
        const Vec3d moment = small * moment_of(kOrthotropic, k);
        const auto inner = [&](std::uint32_t v, double cells) {
          const Vec3d &p = sheet.position[v], margin = cells * Vec3d{sheet.cell, sheet.cell * aspect, 0};
          return p.x > margin.x && p.x < 1 - margin.x && p.y > margin.y && p.y < sheet.width - margin.y;
        };
        double largest = 0, worst = 0, worst_force = 0;
        for (std::size_t h = 0; h < plate.hinges.size(); ++h) {
          const auto& nodes = plate.hinges[h].nodes;
          if (!std::all_of(nodes.begin(), nodes.end(), [&](std::uint32_t v) { return inner(v, 2); }))
            continue;
          const Vec3d edge = sheet.position[nodes[1]] - sheet.position[nodes[0]];
          const double expected =
              (moment.x * edge.y * edge.y + moment.y * edge.x * edge.x - 2 * moment.z * edge.x * edge.y) /
              length(edge);
          worst = std::max(worst, std::abs(m[h] - expected));
          largest = std::max(largest, std::abs(expected));
        }
        for (std::uint32_t v = 0; v < x.size(); ++v)
          if (inner(v, 3)) worst_force = std::max(worst_force, length(force[v]));
        CHECK(largest > 0);
        // The weights' 1e-6, some of them against each other; angles tell curvatures apart the less the longer the
        // triangles are. A force is a sum of moments by eight heights of at least a fifth of a cell.
        CHECK(worst < 1e-5 * aspect * aspect * largest);
        CHECK(worst_force < 1e-4 * aspect * aspect * largest / sheet.cell);
      }
}

TEST_CASE(
    "no weight by which an angle is shared is above one, also at the rim of irregular triangles of 1 : 10") {
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    for (const double aspect : {1.0, 10.0}) {
      const PatternSheet sheet = stretched(pattern_sheet(Pattern::Irregular, 1, 7, 7, 0, 0, seed), aspect);
      double largest = 0;
      for (const Hinge& hinge : build_plate({sheet.position, sheet.triangles}, kOrthotropic).hinges)
        for (const double weight : hinge.shift) largest = std::max(largest, std::abs(weight));
      CHECK(largest < 1);
    }
}

TEST_CASE(
    "a rolled sheet, and a flattened cylinder, have the energy of the bend on every pattern, in every "
    "direction") {
  double worst = 0, worst_flattened = 0, worst_fine = 0;
  for (const Pattern pattern : kPatterns)
    for (int degrees = 0; degrees < 180; degrees += 15) {
      const PatternSheet sheet = pattern_sheet(pattern, 0.12, 12, 12);
      const double direction = degrees * std::acos(-1.0) / 180;
      const auto off = [&](const Stiffness& d, double curvature, bool flattened) {
        const std::vector<Vec3d> round = rolled(sheet, curvature, direction);
        const std::vector<Vec3d>&rest = flattened ? round : sheet.position,
              &x = flattened ? sheet.position : round;
        return std::abs(cylinder_ratio(sheet, d, curvature, direction, rest, x) - 1);
      };
      const Stiffness isotropic = Stiffness::of(Moduli::isotropic(2e-5, 0.3));
      // A tenth of a radian a cell: angles are within (0.1)² of linear. And a thousandth.
      for (const Stiffness& d : {kOrthotropic, isotropic}) {
        worst = std::max(worst, off(d, 10, false));
        worst_fine = std::max(worst_fine, off(d, 0.1, false));
      }
      worst_flattened = std::max(worst_flattened, off(isotropic, 10, true));
    }
  MESSAGE("off by at most " << 100 * worst << " % at 0.1 rad a cell, " << 100 * worst_flattened
                            << " % flattened");
  CHECK(worst < 0.01);
  CHECK(worst_flattened < 0.01);
  CHECK(worst_fine < 1e-5);
}

TEST_CASE("what the halves of angles leave out is half of a modulus on alternating diagonals") {
  // Twisted evenly such a sheet has 2 K12 sqrt(2) at its diagonals alone: halves make K11 = ±K12 of it beside K12.
  const PatternSheet sheet = pattern_sheet(Pattern::Alternating, 0.12, 12, 12);
  const Stiffness d = Stiffness::of(Moduli::isotropic(2e-5, 0));
  Plate halves = build_plate({sheet.position, sheet.triangles}, d);
  std::vector<Vec3d> x = rolled(sheet, 0.1, std::acos(-1.0) / 4);
  const double calibrated = energy(halves, bends(halves, x));
  for (Hinge& hinge : halves.hinges) hinge.shift = {};
  CHECK(energy(halves, bends(halves, x)) / calibrated ==
        doctest::Approx(1.5).epsilon(0.1).scale(0));  // but for the rim
}

TEST_CASE(
    "the Gauss-Newton Hessian of bending is positive semidefinite in 10,000 random states of random sheets") {
  Random random(5);
  double worst = 0;
  for (int sample = 0; sample < 10000; ++sample) {
    PatternSheet sheet =
        pattern_sheet(Pattern::Irregular, 0.02, 2, 2, 0, 0, static_cast<std::uint64_t>(sample));
    const double warp = random.uniform(1, 100), weft = random.uniform(1, 100);
    const double poisson = random.uniform(-0.95, 0.95) * std::sqrt(warp / weft);
    const Stiffness d = Stiffness::of({warp, weft, poisson, random.uniform(1, 100)});
    const Plate plate = build_plate({sheet.position, sheet.triangles}, d);
    std::vector<Vec3d> x = sheet.position;
    for (Vec3d& p : x) p += random_vector(random, 0.01);
    const auto hinges = static_cast<int>(plate.hinges.size());
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(hinges, hinges), slopes = Eigen::MatrixXd::Zero(hinges, 27);
    for (const Coupling& c : couplings(plate))
      m(static_cast<int>(c.row), static_cast<int>(c.column)) += c.entry;
    for (int h = 0; h < hinges; ++h) {
      const Hinge& hinge = plate.hinges[static_cast<std::size_t>(h)];
      const Corners slope = angle_slope(corners_of(hinge, x));
      for (std::size_t i = 0; i < 4; ++i)
        for (int axis = 0; axis < 3; ++axis)
          slopes(h, 3 * static_cast<int>(hinge.nodes[i]) + axis) = slope[i][axis];
    }
    const Eigen::MatrixXd k = slopes.transpose() * m * slopes;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(k, Eigen::EigenvaluesOnly);
    worst = std::min(worst, eigen.eigenvalues()(0) / k.trace());
  }
  CHECK(worst > -1e-12);
}

TEST_CASE("bending's forces are the slope of its energy, and turn nothing") {
  Random random(6);
  for (const Pattern pattern : kPatterns) {
    const PatternSheet sheet = pattern_sheet(pattern, 0.1, 5, 5);
    const Plate plate = build_plate({rolled(sheet, 10, 0.7), sheet.triangles}, kOrthotropic);
    std::vector<Vec3d> x = sheet.position, way, force(x.size());
    for (Vec3d& p : x) p += random_vector(random, 0.005);
    for (std::size_t v = 0; v < x.size(); ++v) way.push_back(random_vector(random, 1));
    add_forces(plate, moments(plate, bends(plate, x)), x, force);
    const auto energy_at = [&](double h) {
      std::vector<Vec3d> place = x;
      for (std::size_t v = 0; v < x.size(); ++v) place[v] += h * way[v];
      return energy(plate, bends(plate, place));
    };
    double work = 0, size = 0;
    Vec3d sum, turn;
    for (std::size_t v = 0; v < x.size(); ++v) {
      work -= dot(force[v], way[v]);
      sum += force[v];
      turn += cross(x[v], force[v]);
      size += length(force[v]);
    }
    // Central differences over h: within (h / 5 mm)² of the forces, the heights of triangles.
    const double h = 1e-7;
    CHECK(std::abs((energy_at(h) - energy_at(-h)) / (2 * h) - work) < 1e-7 * size);
    CHECK(length(sum) < 1e-13 * size);
    CHECK(length(turn) < 1e-13 * size);
  }
}

TEST_CASE(
    "bending costs nothing at rest, flat or creased, and in rigid motion, and resists every other bend") {
  for (const Pattern pattern : kPatterns) {
    const PatternSheet sheet = pattern_sheet(pattern, 0.1, 6, 6);
    for (const double curvature : {1e-9, 15.0}) {
      const std::vector<Vec3d> rest = rolled(sheet, curvature, 0.3);
      const Plate plate = build_plate({rest, sheet.triangles}, kOrthotropic);
      std::vector<Vec3d> moved = rest, force(rest.size());
      for (Vec3d& p : moved) p = Vec3d{p.y, p.z, p.x} + Vec3d{1, 2, 3};
      const std::vector<double> bend = bends(plate, moved);
      CHECK(energy(plate, bend) < 1e-28);
      add_forces(plate, moments(plate, bend), moved, force);
      for (const Vec3d& f : force) CHECK(length(f) < 1e-15);
    }
    // The matrix of moments has no null space: no wrinkle of the mesh is free.
    const Plate plate = build_plate({sheet.position, sheet.triangles}, kOrthotropic);
    const auto n = static_cast<int>(plate.hinges.size());
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n, n);
    for (const Coupling& c : couplings(plate))
      m(static_cast<int>(c.row), static_cast<int>(c.column)) += c.entry;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(m, Eigen::EigenvaluesOnly);
    MESSAGE(name_of(pattern) << ": moments by bends from " << eigen.eigenvalues()(0) << " to "
                             << eigen.eigenvalues()(n - 1));
    CHECK(eigen.eigenvalues()(0) > 0);
    CHECK((m - m.transpose()).norm() < 1e-13 * m.norm());
  }
}
