// The tetrahedron's laws against their own derivatives, mechanics, and closed forms of elasticity.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "base/random.hpp"
#include "element/tet/hessian.hpp"
#include "element/tet/tets.hpp"

using namespace weft;
using namespace weft::tet;

namespace {

constexpr std::array kEnergies = {Energy::NeoHookean, Energy::Corotated};
constexpr double kYoung = 2e5, kPoisson = 0.35;

Law law_of(Energy energy, double delay = 0) { return Law::of(energy, kYoung, kPoisson, delay); }

Vec3d random_vector(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}
Mat3 random_matrix(Random& random, double size) {
  return {random_vector(random, size), random_vector(random, size), random_vector(random, size)};
}

Eigen::Matrix3d eigen(const Mat3& a) {
  Eigen::Matrix3d made;
  made << a.x.x, a.x.y, a.x.z, a.y.x, a.y.y, a.y.z, a.z.x, a.z.y, a.z.z;
  return made;
}

/// By the singular values, of whichever the least is turned where F is inside out.
Eigen::Matrix3d rotation_by_svd(const Eigen::Matrix3d& f) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d sign = Eigen::Matrix3d::Identity();
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0) sign(2, 2) = -1;
  return svd.matrixU() * sign * svd.matrixV().transpose();
}

Mat3 rotation(Random& random) {
  const Mat3 some = random_matrix(random, 1);
  return nearest_rotation(some);
}

/// A block whose inner nodes are moved at random, so that no two tetrahedra are alike.
mesh::TetMesh uneven_block(std::uint32_t cells, const Vec3d& size, std::uint64_t seed) {
  mesh::TetMesh made = mesh::block({cells, cells, cells}, size);
  Random random(seed);
  const double free = 0.2 / cells;
  for (Vec3f& p : made.positions) {
    Vec3d x = p.to<double>();
    bool inner = true;
    for (int axis = 0; axis < 3; ++axis) inner = inner && std::abs(x[axis]) < 0.499 * size[axis];
    const Vec3d move = random_vector(random, free);
    if (inner) x = x + Vec3d{move.x * size.x, move.y * size.y, move.z * size.z};
    p = x.to<float>();
  }
  return made;
}

std::vector<Vec3d> places_of(const mesh::TetMesh& mesh) {
  std::vector<Vec3d> x;
  for (const Vec3f& p : mesh.positions) x.push_back(p.to<double>());
  return x;
}

double sum_of_volumes(const Tets& tets) {
  return std::accumulate(tets.rests.begin(), tets.rests.end(), 0.0,
                         [](double sum, const Rest& rest) { return sum + rest.volume; });
}

/// The stretch across where a bar is pulled to `along` and nothing pulls across, by bisection of
/// ∂ψ/∂l2 = 0 with ψ = µ/2 (l1² + 2 l2² - 3) - µ (J - 1) + (λ + µ)/2 (J - 1)², written out here.
double across_neo_hookean(const Law& law, double along) {
  double low = 0.1, high = 3;
  for (int step = 0; step < 200; ++step) {
    const double b = (low + high) / 2, grown = along * b * b - 1;
    const double slope = law.mu * b - law.mu * along * b + (law.lambda + law.mu) * grown * along * b;
    (slope > 0 ? high : low) = b;
  }
  return low;
}

}  // namespace

TEST_CASE("stress is the slope of energy, in states that are squeezed, stretched and turned inside out") {
  Random random(3);
  for (const Energy energy : kEnergies)
    for (int trial = 0; trial < 300; ++trial) {
      const Law law = law_of(energy);
      const Mat3 f =
          Mat3::identity(trial % 3 == 0 ? 0 : 1) + random_matrix(random, trial % 2 == 0 ? 0.3 : 1.5);
      if (energy == Energy::Corotated) {  // where two rotations are as near, the energy has an edge
        Eigen::JacobiSVD<Eigen::Matrix3d> svd(eigen(f));
        const auto s = svd.singularValues();
        const double least = eigen(f).determinant() < 0 ? s(1) - s(2) : s(1) + s(2);
        if (least < 0.05) continue;
      }
      const Mat3 p = stress(law, f), way = random_matrix(random, 1);
      const double h = 1e-5;
      const double slope = (tet::energy(law, f + h * way) - tet::energy(law, f + -h * way)) / (2 * h);
      const double expected = dot(p.x, way.x) + dot(p.y, way.y) + dot(p.z, way.z);
      CHECK(std::abs(slope - expected) < 1e-5 * kYoung);  // h² by third derivatives of some tens of µ
    }
}

TEST_CASE("the nearest rotation is that of the singular values, and never a mirror image") {
  Random random(5);
  for (int trial = 0; trial < 20000; ++trial) {
    const Mat3 f = random_matrix(random, std::pow(10.0, random.uniform(-6, 6)));
    const Eigen::Matrix3d r = eigen(nearest_rotation(f)), expected = rotation_by_svd(eigen(f));
    CHECK((r * r.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-13);
    CHECK(r.determinant() > 0);
    const auto s = Eigen::JacobiSVD<Eigen::Matrix3d>(eigen(f)).singularValues();
    const double gap = (eigen(f).determinant() < 0 ? s(1) - s(2) : s(1) + s(2)) / s(0);
    CHECK((r - expected).norm() < 1e-13 / std::max(gap, 1e-13));
  }
  CHECK(eigen(nearest_rotation({})).isApprox(Eigen::Matrix3d::Identity()));  // of nothing: any
}

TEST_CASE("a body that is turned and moved has no energy, no force, no damping") {
  Random random(7);
  const mesh::TetMesh mesh = uneven_block(3, {0.3, 0.2, 0.4}, 1);
  const std::vector<Vec3d> rest = places_of(mesh);
  for (const Energy energy : kEnergies) {
    const Tets tets = Tets::of(rest, mesh.tets, law_of(energy, 0.01));
    const Mat3 r = rotation(random);
    const Vec3d spin = random_vector(random, 20);
    std::vector<Vec3d> x, v, forces(rest.size());
    for (const Vec3d& p : rest) {
      x.push_back(r * p + Vec3d{3, -2, 1});
      v.push_back(cross(spin, r * p) + Vec3d{1, 2, 3});
    }
    CHECK(std::abs(tets.energy(x)) < 1e-12 * kYoung * sum_of_volumes(tets));
    tets.add_forces(x, forces);
    tets.add_damping_forces(x, v, forces);
    for (const Vec3d& f : forces) CHECK(length(f) < 1e-9 * kYoung * 0.01);  // of the face of a cell
  }
}

TEST_CASE("forces sum to nothing and turn nothing; damping takes energy and gives none") {
  Random random(11);
  const mesh::TetMesh mesh = uneven_block(3, {0.3, 0.2, 0.4}, 2);
  const std::vector<Vec3d> rest = places_of(mesh);
  for (const Energy energy : kEnergies)
    for (int trial = 0; trial < 50; ++trial) {
      const Tets tets = Tets::of(rest, mesh.tets, law_of(energy, 0.02));
      std::vector<Vec3d> x, v;
      for (const Vec3d& p : rest) {
        x.push_back(p + random_vector(random, trial % 2 == 0 ? 0.02 : 0.2));
        v.push_back(random_vector(random, 5));
      }
      std::vector<Vec3d> elastic(rest.size()), damping(rest.size());
      tets.add_forces(x, elastic);
      tets.add_damping_forces(x, v, damping);
      Vec3d sum, turn;
      double size = 0, power = 0;
      for (std::size_t n = 0; n < x.size(); ++n) {
        const Vec3d f = elastic[n] + damping[n];
        sum += f;
        turn += cross(x[n], f);
        size += length(f);
        power += dot(damping[n], v[n]);
      }
      CHECK(length(sum) < 1e-13 * size);
      CHECK(length(turn) < 1e-13 * size);
      CHECK(power < 0);
    }
}

TEST_CASE("patch test: where a body's surface is strained evenly, all of it is") {
  const mesh::TetMesh mesh = uneven_block(4, {0.3, 0.2, 0.4}, 3);
  const std::vector<Vec3d> rest = places_of(mesh);
  const Mat3 f = Mat3{{1.2, 0.3, -0.1}, {0.05, 0.8, 0.2}, {-0.15, 0.1, 1.1}};
  std::vector<bool> outer(rest.size(), false);
  for (const mesh::Triangle& t : mesh::boundary(mesh.tets))
    for (const std::uint32_t n : t) outer[n] = true;
  CHECK(std::count(outer.begin(), outer.end(), false) == 27);
  for (const Energy energy : kEnergies) {
    const Tets tets = Tets::of(rest, mesh.tets, law_of(energy));
    std::vector<Vec3d> x, forces(rest.size());
    for (const Vec3d& p : rest) x.push_back(f * p);
    CHECK(tets.energy(x) == doctest::Approx(0.3 * 0.2 * 0.4 * tet::energy(tets.law, f)).epsilon(1e-6));
    tets.add_forces(x, forces);
    for (std::size_t n = 0; n < x.size(); ++n)
      if (!outer[n])
        CHECK(length(forces[n]) < 1e-7 * kYoung * 0.01);  // places in f32 leave volumes of 1 + 1e-7
  }
}

TEST_CASE("at small strain both energies are Hooke's law: E along, ν across, G in shear, K in volume") {
  const double e = 1e-6, shear = kYoung / (2 * (1 + kPoisson)), bulk = kYoung / (3 * (1 - 2 * kPoisson));
  for (const Energy energy : kEnergies) {
    const Law law = law_of(energy);
    const Mat3 along = stress(law, {{1 + e, 0, 0}, {0, 1 - kPoisson * e, 0}, {0, 0, 1 - kPoisson * e}});
    CHECK(along.x.x / e == doctest::Approx(kYoung).epsilon(1e-5));
    CHECK(std::abs(along.y.y) < 1e-4 * kYoung * e);
    const Mat3 sheared = stress(law, {{1, e, 0}, {0, 1, 0}, {0, 0, 1}});
    CHECK(sheared.x.y / e == doctest::Approx(shear).epsilon(1e-5));
    CHECK(sheared.y.x / e == doctest::Approx(shear).epsilon(1e-5));
    const Mat3 grown = stress(law, Mat3::identity(1 + e));
    CHECK(grown.z.z / (3 * e) == doctest::Approx(bulk).epsilon(1e-5));
  }
}

TEST_CASE("large strain: a neo-Hookean bar pulled in one direction, and both energies in simple shear") {
  const Law law = law_of(Energy::NeoHookean);
  for (const double along : {0.5, 0.8, 1.5, 3.0}) {
    const double across = across_neo_hookean(law, along);
    const Mat3 p = stress(law, {{along, 0, 0}, {0, across, 0}, {0, 0, across}});
    CHECK(std::abs(p.y.y) < 1e-9 * kYoung);
    // dψ/dl1 of the energy along the line of free sides, by differences of the energy alone.
    const auto free = [&](double l) {
      const double b = across_neo_hookean(law, l);
      return tet::energy(law, {{l, 0, 0}, {0, b, 0}, {0, 0, b}});
    };
    CHECK(p.x.x == doctest::Approx((free(along + 1e-5) - free(along - 1e-5)) / 2e-5).epsilon(1e-6));
  }
  // J = 1 in simple shear: ψ = µ γ²/2 exactly.
  for (const double g : {0.1, 1.0, 4.0}) {
    const Mat3 f = {{1, g, 0}, {0, 1, 0}, {0, 0, 1}};
    CHECK(tet::energy(law, f) == doctest::Approx(law.mu * g * g / 2).epsilon(1e-12));
    CHECK(stress(law, f).x.y == doctest::Approx(law.mu * g).epsilon(1e-12));
    // Corotated: by principal stretches l and 1/l with l - 1/l = γ: µ ((l - 1)² + (1/l - 1)²) + λ/2 (l + 1/l - 2)².
    const Law other = law_of(Energy::Corotated);
    const double l = (g + std::sqrt(g * g + 4)) / 2, m = 1 / l, grown = l + m - 2;
    const double expected =
        other.mu * ((l - 1) * (l - 1) + (m - 1) * (m - 1)) + other.lambda / 2 * grown * grown;
    CHECK(tet::energy(other, f) == doctest::Approx(expected).epsilon(1e-12));
  }
}

TEST_CASE("neo-Hookean energy is a parabola of one corner's place, the others still, inside out too") {
  Random random(13);
  for (int trial = 0; trial < 2000; ++trial) {
    Corners x;
    do {
      for (Vec3d& c : x) c = random_vector(random, 0.02);
    } while (mesh::six_volumes(x) < 1e-7);
    const Rest rest = Rest::of(x);
    for (Vec3d& c : x) c = random_vector(random, 0.04);
    const Law law = law_of(Energy::NeoHookean);
    const auto corner = static_cast<std::size_t>(trial % 4);
    const CornerPull pull = corner_pull(law, rest, deformation(rest, x), deformation(rest, x), 0, corner);
    const Vec3d way = random_vector(random, 0.05);
    const double before = rest.volume * tet::energy(law, deformation(rest, x));
    x[corner] = x[corner] + way;
    const double after = rest.volume * tet::energy(law, deformation(rest, x));
    const double parabola = -dot(pull.force, way) + 0.5 * dot(way, pull.hessian * way);
    const double size = std::abs(before) + std::abs(after) + std::abs(parabola);
    CHECK(std::abs(after - before - parabola) < 1e-11 * size);
  }
}

TEST_CASE("what a corner resists with is never negative, and with its damping a bound of how force grows") {
  Random random(17);
  for (const Energy energy : kEnergies)
    for (int trial = 0; trial < 2000; ++trial) {
      Corners x, start;
      do {
        for (Vec3d& c : x) c = random_vector(random, 0.02);
      } while (mesh::six_volumes(x) < 1e-7);
      const Rest rest = Rest::of(x);
      for (std::size_t k = 0; k < 4; ++k) start[k] = x[k] + random_vector(random, 0.01);
      for (Vec3d& c : x) c = random_vector(random, 0.05);
      const Law law = law_of(energy, 0.01);
      const CornerPull pull = corner_pull(law, rest, deformation(rest, x), deformation(rest, start), 500,
                                          static_cast<std::size_t>(trial % 4));
      const Eigen::Matrix3d h = eigen(pull.hessian);
      CHECK((h - h.transpose()).norm() < 1e-12 * h.norm());
      CHECK(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(h).eigenvalues()(0) > 0);
    }
}

using Matrix9 = Eigen::Matrix<double, 9, 9>;

Mat3 unit(int entry) {
  Mat3 made{};
  (entry / 3 == 0 ? made.x : entry / 3 == 1 ? made.y : made.z)[entry % 3] = 1;
  return made;
}

/// By what a unit of each entry of F makes of the nine of P.
template <class Change>
Matrix9 matrix_of(const Change& change) {
  Matrix9 made;
  for (int column = 0; column < 9; ++column) {
    const Mat3 p = change(unit(column));
    for (int row = 0; row < 9; ++row)
      made(row, column) = (row / 3 == 0 ? p.x : row / 3 == 1 ? p.y : p.z)[row % 3];
  }
  return made;
}

TEST_CASE("the Hessian is the slope of stress with its negative eigenvalues taken out") {
  Random random(23);
  std::size_t indefinite = 0, tried = 0;
  for (const Energy energy : kEnergies)
    for (int trial = 0; trial < 400; ++trial) {
      const Law law = law_of(energy);
      const Mat3 f = Mat3::identity(1) + random_matrix(random, trial % 2 == 0 ? 0.2 : 1);
      const Frame frame = frame_of(f);
      auto s = frame.stretches;
      std::sort(s.begin(), s.end());
      if (s[0] + s[1] < 0.2) continue;  // two rotations are nearly as near: the stress of (2) has an edge
      const double h = 1e-5;
      const Matrix9 slope = matrix_of([&](const Mat3& way) {
        return 1 / (2 * h) * (stress(law, f + h * way) + -1.0 * stress(law, f + -h * way));
      });
      const Eigen::SelfAdjointEigenSolver<Matrix9> parts(0.5 * (slope + slope.transpose()));
      const Matrix9 expected = parts.eigenvectors() * parts.eigenvalues().cwiseMax(0).asDiagonal() *
                               parts.eigenvectors().transpose();
      const Hessian hessian = positive_hessian(law, frame);
      const Matrix9 made = matrix_of([&](const Mat3& way) { return times(frame, hessian, way); });
      // h² by third derivatives of some hundreds of µ, where two stretches sum to 0.2.
      CHECK((made - expected).norm() < 1e-5 * kYoung);
      ++tried;
      if (parts.eigenvalues()(0) < -0.01 * kYoung) ++indefinite;
    }
  CHECK(indefinite > tried / 4);
  CHECK(tried > 500);
}

TEST_CASE(
    "the Hessian of a tetrahedron that is scattered, flat or inside out is symmetric and never negative") {
  Random random(29);
  for (const Energy energy : kEnergies)
    for (int trial = 0; trial < 10000; ++trial) {
      const Law law = law_of(energy, 0.01);
      Mat3 f = random_matrix(random, std::pow(10.0, random.uniform(-3, 1)));
      if (trial % 5 == 0) f.z = {};  // flat
      const Frame frame = frame_of(f);
      const Hessian damping = 500 * damping_hessian(law, frame);
      for (const Hessian& both : {positive_hessian(law, frame) + damping,
                                  held_hessian(law, frame, random_matrix(random, 1)) + damping}) {
        const Matrix9 made = matrix_of([&](const Mat3& way) { return times(frame, both, way); });
        const double size = made.norm();
        REQUIRE(std::isfinite(size));
        CHECK((made - made.transpose()).norm() < 1e-12 * size);
        CHECK(Eigen::SelfAdjointEigenSolver<Matrix9>(0.5 * (made + made.transpose())).eigenvalues()(0) >
              -1e-12 * size);
      }
    }
}

TEST_CASE(
    "across what presses a step's matrix resists by as much as pressure gives way there, by differences") {
  Random random(37);
  for (const Energy energy : kEnergies) {
    const Law law = law_of(energy);
    int held = 0;
    for (int trial = 0; trial < 200; ++trial) {
      // A rod along an axis of its own, pressed and as wide as it likes, and turned.
      const double pressed = random.uniform(0.85, 0.99);
      double wide = 1;
      for (int step = 0; step < 60; ++step)
        wide -= stress(law, {{pressed, 0, 0}, {0, wide, 0}, {0, 0, wide}}).y.y / (10 * kYoung);
      const Mat3 turned = nearest_rotation(random_matrix(random, 1));
      const Mat3 f = turned * Mat3{{pressed, 0, 0}, {0, wide, 0}, {0, 0, wide}};
      const Frame frame = frame_of(f);
      const Vec3d along{1, 0, 0}, aside{0, std::cos(trial), std::sin(trial)};
      // The axis turns to the side, and the side back: F changes by a rotation times the sum of both stretches.
      const Mat3 turn = turned * (Mat3::outer(aside, along) + -1.0 * Mat3::outer(along, aside));
      const double h = 1e-5;
      const Mat3 gives = 1 / (2 * h) * (stress(law, f + h * turn) + -1.0 * stress(law, f + -h * turn));
      const double slope = contraction(turn, gives);
      const double made = contraction(turn, times(frame, held_hessian(law, frame, {}), turn));
      if (slope < -1e-3 * kYoung) ++held;
      CHECK(made == doctest::Approx(std::abs(slope)).epsilon(1e-4));
      // Where a way takes the pressure off and pulls as much, that holds as well.
      const Mat3 pull =
          turned * Mat3{{2 * (1 - pressed), 0, 0}, {0, 2 * (1 - wide), 0}, {0, 0, 2 * (1 - wide)}};
      const double then = contraction(turn, times(frame, held_hessian(law, frame, pull), turn));
      CHECK(then == doctest::Approx(std::abs(slope)).epsilon(0.5));
    }
    CHECK(held > 150);
  }
}

TEST_CASE(
    "damping's Hessian is what damping adds to stress, and blocks are the Hessian by two shape functions") {
  Random random(31);
  for (const Energy energy : kEnergies)
    for (int trial = 0; trial < 300; ++trial) {
      const Law law = law_of(energy, 0.02);
      Corners x;
      do {
        for (Vec3d& c : x) c = random_vector(random, 0.02);
      } while (mesh::six_volumes(x) < 1e-7);
      const Rest rest = Rest::of(x);
      for (Vec3d& c : x) c += random_vector(random, 0.01);
      const Mat3 f = deformation(rest, x), rate = random_matrix(random, 3);
      const Frame frame = frame_of(f);
      const Eigen::Matrix3d damped = eigen(damping_stress(law, f, rate)),
                            made = eigen(times(frame, damping_hessian(law, frame), rate));
      CHECK((damped - made).norm() < 1e-10 * damped.norm());

      const Hessian hessian = positive_hessian(law, frame);
      const auto column = static_cast<std::size_t>(trial % 4);
      Corners away{};
      away[column] = random_vector(random, 1);
      const Corners pulls = forces(rest, times(frame, hessian, deformation(rest, away)));
      for (std::size_t row = 0; row < 4; ++row) {
        const Vec3d pull = -1.0 * (block(frame, hessian, rest, row, column) * away[column]);
        CHECK(length(pull - pulls[row]) < 1e-9 * (length(pulls[0]) + length(pulls[1]) + length(pulls[2])));
      }
    }
}

TEST_CASE("the surface of a block is closed, faces outward, and holds its volume") {
  for (const std::array<std::uint32_t, 3> cells :
       {std::array<std::uint32_t, 3>{1, 1, 1}, {2, 3, 5}, {7, 1, 4}}) {
    const Vec3d size{0.3, 0.5, 0.7};
    const mesh::TetMesh block = mesh::block(cells, size);
    const mesh::TriangleMesh surface{block.positions, mesh::boundary(block.tets)};
    CHECK(mesh::signed_volume(surface) == doctest::Approx(size.x * size.y * size.z).epsilon(1e-6));
    const auto [nx, ny, nz] = cells;
    CHECK(surface.triangles.size() == 4 * (nx * ny + ny * nz + nz * nx));
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (const mesh::Triangle& t : surface.triangles)
      for (std::size_t k = 0; k < 3; ++k) edges.push_back({t[k], t[(k + 1) % 3]});
    std::sort(edges.begin(), edges.end());
    CHECK(std::adjacent_find(edges.begin(), edges.end()) == edges.end());  // each way once
    for (const auto& [a, b] : edges)
      CHECK(std::binary_search(edges.begin(), edges.end(), std::array<std::uint32_t, 2>{b, a}));
    double sum = 0;
    for (const mesh::Tet& t : block.tets) {
      const double six =
          mesh::six_volumes({block.positions[t[0]].to<double>(), block.positions[t[1]].to<double>(),
                             block.positions[t[2]].to<double>(), block.positions[t[3]].to<double>()});
      CHECK(six > 0);
      sum += six / 6;
    }
    CHECK(sum == doctest::Approx(size.x * size.y * size.z).epsilon(1e-6));
  }
}

namespace {

/// How far the end of a beam that is clamped at one end sinks by a load there, of small strain: by conjugate gradients
/// on the stiffness at rest.
double beam_deflection(std::uint32_t across, const Law& law, double long_side, double side, double load) {
  const std::uint32_t along = across * static_cast<std::uint32_t>(std::lround(long_side / side));
  const mesh::TetMesh mesh = mesh::block({along, across, across}, {long_side, side, side});
  const std::vector<Vec3d> rest = places_of(mesh);
  Tets tets = Tets::of(rest, mesh.tets, law);
  tets.law.delay = 1;
  std::vector<bool> held(rest.size());
  std::vector<Vec3d> b(rest.size());
  double end_nodes = 0;
  for (std::size_t n = 0; n < rest.size(); ++n) held[n] = rest[n].x < -0.4999 * long_side;
  std::vector<double> weights(rest.size(), 0);  // of the end's face, by its triangles
  for (const mesh::Triangle& t : mesh::boundary(mesh.tets)) {
    bool end = true;
    for (const std::uint32_t n : t) end = end && rest[n].x > 0.4999 * long_side;
    if (!end) continue;
    for (const std::uint32_t n : t) weights[n] += 1;
    end_nodes += 3;
  }
  for (std::size_t n = 0; n < rest.size(); ++n) b[n].y = load * weights[n] / end_nodes;
  const auto apply = [&](const std::vector<Vec3d>& x) {
    std::vector<Vec3d> y(x.size());
    tets.add_damping_forces(rest, x, y);
    for (std::size_t n = 0; n < y.size(); ++n) y[n] = held[n] ? Vec3d{} : -1.0 * y[n];
    return y;
  };
  const auto product = [](const std::vector<Vec3d>& p, const std::vector<Vec3d>& q) {
    double sum = 0;
    for (std::size_t n = 0; n < p.size(); ++n) sum += dot(p[n], q[n]);
    return sum;
  };
  std::vector<Vec3d> x(rest.size()), r = b, p = b;
  double rr = product(r, r);
  const double first = rr;
  for (int k = 0; k < 5000 && rr > 1e-16 * first; ++k) {
    const std::vector<Vec3d> q = apply(p);
    const double a = rr / product(p, q);
    for (std::size_t n = 0; n < x.size(); ++n) {
      x[n] += a * p[n];
      r[n] -= a * q[n];
    }
    const double next = product(r, r);
    for (std::size_t n = 0; n < x.size(); ++n) p[n] = r[n] + next / rr * p[n];
    rr = next;
  }
  CHECK(rr <= 1e-16 * first);
  return product(x, b) / load;
}

}  // namespace

TEST_CASE("a beam that is clamped at one end converges to Timoshenko's, to the second order in its cells") {
  // L = 8 a, ν = 0, so that the clamp constrains nothing that the beam's theory leaves free.
  const double side = 0.1, span = 0.8, load = 1;
  const Law law = Law::of(Energy::NeoHookean, kYoung, 0, 0);
  const double inertia = std::pow(side, 4) / 12, area = side * side, shear = kYoung / 2;
  // The shear coefficient of a square where ν = 0 is 5/6 (Cowper 1966).
  const double expected =
      load * std::pow(span, 3) / (3 * kYoung * inertia) + load * span / (5.0 / 6 * shear * area);
  std::vector<double> errors;
  for (const std::uint32_t across : {2U, 4U, 8U}) {
    errors.push_back(1 - beam_deflection(across, law, span, side, load) / expected);
    MESSAGE(across << " cells across: " << errors.back() << " too stiff");
    CHECK(errors.back() >
          -0.005);  // linear tetrahedra are too stiff, never too soft; theory of beams is within 0.5 %
  }
  const double order = std::log2(errors[0] / errors[1]);
  CHECK(order > 1.5);
  CHECK(errors[2] < 0.05);
}
