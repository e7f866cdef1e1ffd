// The membrane's laws against their own derivatives, mechanics, and closed forms.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "closed_forms/pattern_sheet.hpp"
#include "element/membrane/build.hpp"
#include "element/membrane/form.hpp"
#include "element/membrane/law.hpp"

using namespace weft;
using namespace weft::membrane;

namespace {

constexpr std::array kEnergies = {Energy::Green, Energy::Yarn, Energy::NeoHookean};

/// Cotton poplin's order of magnitude, or a sheet without axes, which is all that neo-Hookean cloth can be.
Moduli moduli_of(Energy energy) {
  if (energy == Energy::NeoHookean) return {500, 500, 0.3, 500 / (2 * 1.3)};
  return {800, 300, 0.2, 40};
}

Law law_of(Energy energy) { return {energy, Stiffness::of(moduli_of(energy)), 0.02}; }

Vec3d random_vector(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

/// A triangle at rest with sides of centimetres, and its corners displaced by up to `size` of that in all directions.
struct State {
  Rest rest;
  Corners place, velocity;

  State(Random& random, double size) {
    std::array<MaterialPoint, 3> corners;
    do {
      for (MaterialPoint& c : corners) c = {random.uniform(0, 0.03), random.uniform(0, 0.03)};
      rest = Rest::of(corners);
    } while (rest.area < 5e-5);
    for (std::size_t i = 0; i < 3; ++i) {
      place[i] = Vec3d{corners[i].warp, corners[i].weft, 0} + random_vector(random, 0.01 * size);
      velocity[i] = random_vector(random, 1);
    }
  }
  Axes deformation() const { return membrane::deformation(rest, place); }
};

double energy_at(const Law& law, const Rest& rest, const Corners& x) {
  return rest.area * energy(law, deformation(rest, x));
}
Corners forces_at(const Law& law, const Rest& rest, const Corners& x) {
  return forces(rest, stress(law, deformation(rest, x)));
}

using Matrix9 = Eigen::Matrix<double, 9, 9>;
Matrix9 dense(const Blocks& blocks) {
  Matrix9 all;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Mat3& b = blocks[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      all.block<3, 3>(3 * i, 3 * j) << b.x.x, b.x.y, b.x.z, b.y.x, b.y.y, b.y.z, b.z.x, b.z.y, b.z.z;
    }
  return all;
}

/// A sheet pulled along one axis, free along the other: force per width at rest [N/m], and how much it contracts.
struct Uniaxial {
  double force, contraction;

  Uniaxial(const Law& law, double stretch, bool along_warp = true) {
    double other = 1;
    for (int step = 0; step < 50; ++step) {
      const Axes f = axes(stretch, other, along_warp);
      const Axes p = stress(law, f);
      const Hessian h = hessian(law, f);
      other -= along_warp ? p.weft.y / h.weft.y.y : p.warp.x / h.warp.x.x;
    }
    const Axes p = stress(law, axes(stretch, other, along_warp));
    force = along_warp ? p.warp.x : p.weft.y;
    contraction = 1 - other;
  }
  static Axes axes(double stretch, double other, bool along_warp) {
    return along_warp ? Axes{{stretch, 0, 0}, {0, other, 0}} : Axes{{other, 0, 0}, {0, stretch, 0}};
  }
};

/// A square patch of n x n cells whose inner nodes are off their places, as triangles.
struct Patch {
  int n = 6;
  std::vector<MaterialPoint> place;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<Rest> rests;

  explicit Patch(std::uint64_t seed) {
    Random random(seed);
    const auto moved = [&](int i) { return i == 0 || i == n ? 0.0 : random.uniform(-0.3, 0.3); };
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) place.push_back({(i + moved(i)) * 0.01, (j + moved(j)) * 0.01});
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const std::size_t a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1), d = node(i, j + 1);
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      }
    for (const auto& t : triangles) rests.push_back(Rest::of({place[t[0]], place[t[1]], place[t[2]]}));
  }
  std::size_t node(int i, int j) const { return static_cast<std::size_t>(j * (n + 1) + i); }
  bool inner(std::size_t v) const {
    const int i = static_cast<int>(v) % (n + 1), j = static_cast<int>(v) / (n + 1);
    return i > 0 && j > 0 && i < n && j < n;
  }
  Corners corners(std::size_t t, const std::vector<Vec3d>& x) const {
    return {x[triangles[t][0]], x[triangles[t][1]], x[triangles[t][2]]};
  }
  std::vector<Vec3d> forces(const Law& law, const std::vector<Vec3d>& x) const {
    std::vector<Vec3d> sum(x.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const Corners f = forces_at(law, rests[t], corners(t, x));
      for (std::size_t i = 0; i < 3; ++i) sum[triangles[t][i]] += f[i];
    }
    return sum;
  }
};

}  // namespace

TEST_CASE(
    "every energy is half its form, but for a constant, and its stress is the form's slopes by what they "
    "hold") {
  Random random(31);
  for (const Energy kind : kEnergies) {
    const Law law = law_of(kind);
    for (int turn = 0; turn < 40; ++turn) {
      const Axes f = State(random, 0.8).deformation();
      const Form form = membrane::form(law, f);
      const auto& [warp, weft, shear] = form.strain.value;
      const Stiffness& k = form.stiffness;
      const double held_warp = k.warp * warp + k.coupled * weft, held_weft = k.coupled * warp + k.weft * weft,
                   held_shear = k.shear * shear;
      const double half = (held_warp * warp + held_weft * weft + held_shear * shear) / 2;
      CHECK(half == doctest::Approx(energy(law, f)).epsilon(1e-9));  // 0 at rest, both
      const Axes exact = stress(law, f);
      const double size = length(exact.warp) + length(exact.weft);
      CHECK(length(held_warp * form.strain.warp.warp + held_weft * form.strain.weft.warp +
                   held_shear * form.strain.shear.warp - exact.warp) < 1e-9 * size);
      CHECK(length(held_warp * form.strain.warp.weft + held_weft * form.strain.weft.weft +
                   held_shear * form.strain.shear.weft - exact.weft) < 1e-9 * size);
    }
  }
}

TEST_CASE("a form's steep slopes are its own at rest, and not short where an axis or an angle has closed") {
  const Axes rest{{1, 0, 0}, {0, 1, 0}};
  for (const Energy kind : kEnergies) {
    const Strain own = form(law_of(kind), rest).strain, steep = steep_slopes(kind, rest);
    for (const auto& [a, b] :
         {std::pair{own.warp, steep.warp}, {own.weft, steep.weft}, {own.shear, steep.shear}}) {
      CHECK(length(a.warp - b.warp) < 1e-15);
      CHECK(length(a.weft - b.weft) < 1e-15);
    }
    // An axis or an angle that has closed: no slope is short.
    for (const Axes& closed : {Axes{{1e-3, 0, 0}, {0, 1e-3, 0}}, Axes{{1, 0, 0}, {1, 1e-4, 0}}}) {
      const Strain shut = steep_slopes(kind, closed);
      for (const Axes& slope : {shut.warp, shut.weft, shut.shear})
        CHECK(length(slope.warp) + length(slope.weft) > 0.9);
    }
  }
}

TEST_CASE("a membrane's forces are the slope of its energy, and its blocks that of its forces") {
  Random random(1);
  for (const Energy kind : kEnergies)
    for (int sample = 0; sample < 200; ++sample) {
      const Law law = law_of(kind);
      const State s(random, 0.7);
      Corners way;
      for (Vec3d& w : way) w = random_vector(random, 1);
      const auto moved = [&](double h) {
        Corners x = s.place;
        for (std::size_t i = 0; i < 3; ++i) x[i] += h * way[i];
        return x;
      };
      const Corners f = forces_at(law, s.rest, s.place);
      const Matrix9 k = dense(blocks(s.rest, hessian(law, s.deformation())));
      // Central differences over 1e-4 of a side are within about 1e-8 of the stiffness, times the moves' third
      // derivatives; small triangles and stretched ones have them up to a thousand times larger.
      const double h = 1e-6, stiffness = k.norm();
      const double slope = (energy_at(law, s.rest, moved(h)) - energy_at(law, s.rest, moved(-h))) / (2 * h);
      double work = 0;
      for (std::size_t i = 0; i < 3; ++i) work -= dot(f[i], way[i]);
      CHECK(std::abs(slope - work) < 1e-8 * stiffness);
      const Corners after = forces_at(law, s.rest, moved(h)), before = forces_at(law, s.rest, moved(-h));
      Eigen::Matrix<double, 9, 1> change, direction;
      for (int i = 0; i < 9; ++i) {
        const auto corner = static_cast<std::size_t>(i / 3);
        change(i) = -(after[corner][i % 3] - before[corner][i % 3]) / (2 * h);
        direction(i) = way[corner][i % 3];
      }
      CHECK((k * direction - change).norm() < 1e-5 * stiffness);
      CHECK((k - k.transpose()).norm() < 1e-14 * stiffness);
    }
}

TEST_CASE("the blocks for solvers are positive semidefinite in 10,000 random states") {
  Random random(2);
  for (const Energy kind : kEnergies) {
    const Law law = law_of(kind);
    double worst = 0;
    for (int sample = 0; sample < 10000; ++sample) {
      const State s(random, 2);  // turned over, crushed, and stretched threefold
      const Axes way = deformation(s.rest, s.velocity);
      for (const Hessian& h :
           {positive_hessian(law, s.deformation()), held_hessian(law, s.deformation(), way),
            damping_hessian(law, s.deformation())}) {
        const Matrix9 k = dense(blocks(s.rest, h));
        const Eigen::SelfAdjointEigenSolver<Matrix9> eigen(k, Eigen::EigenvaluesOnly);
        worst = std::min(worst, eigen.eigenvalues()(0) / k.trace());
      }
    }
    CHECK(worst > -1e-12);
  }
}

TEST_CASE("where the Hessian is positive the blocks for solvers are the Hessian") {
  Random random(3);
  for (const Energy kind : kEnergies)
    for (int sample = 0; sample < 50; ++sample) {
      const State s(random, 0);
      const Axes f = s.deformation();
      const Matrix9 exact = dense(blocks(s.rest, hessian(law_of(kind), f)));
      CHECK((dense(blocks(s.rest, positive_hessian(law_of(kind), f))) - exact).norm() < 1e-13 * exact.norm());
    }
  // Green's: in every state of tension along both axes.
  const Axes f{{1.1, 0.1, 0.2}, {0, 1.05, 0.1}};
  const Law law = law_of(Energy::Green);
  const State s(random, 0);
  const Matrix9 exact = dense(blocks(s.rest, hessian(law, f)));
  CHECK((dense(blocks(s.rest, positive_hessian(law, f))) - exact).norm() < 1e-13 * exact.norm());
}

TEST_CASE("across what presses a step's matrix resists by as much as pressure gives way there") {
  for (const Energy kind : kEnergies) {
    const Law law = law_of(kind);
    for (const double pressed : {0.995, 0.9}) {
      // Freely wide: all of the stress is along the warp.
      const Moduli moduli = moduli_of(kind);
      Axes f{{pressed, 0, 0}, {0, 1 + moduli.poisson * (1 - pressed), 0}};
      for (int step = 0; step < 20; ++step) f.weft.y -= stress(law, f).weft.y / hessian(law, f).weft.y.y;
      const double pulls = stress(law, f).warp.x;
      REQUIRE(pulls < 0);
      const Vec3d out{0, 0, 1};
      const double gives = dot(out, hessian(law, f).warp * out);  // by a rotation about the weft
      CHECK(gives == doctest::Approx(pulls / pressed).epsilon(1e-6));
      CHECK(dot(out, held_hessian(law, f, {}).warp * out) == doctest::Approx(-gives).epsilon(1e-6));
      CHECK(std::abs(dot(out, positive_hessian(law, f).warp * out)) < 1e-6 * moduli.warp);

      // A way that presses further is resisted by the pressure at its end, and one to twice as much of a pull by that.
      const Axes onward{{pressed - 1, 0, 0}, {0, f.weft.y - 1, 0}};
      const double then = dot(out, held_hessian(law, f, onward).warp * out);
      CHECK(then == doctest::Approx(-2 * gives).epsilon(pressed == 0.995 ? 0.02 : 0.35));
      const Axes back{-3 * onward.warp, -3 * onward.weft};
      CHECK(dot(out, held_hessian(law, f, back).warp * out) ==
            doctest::Approx(-2 * gives).epsilon(pressed == 0.995 ? 0.05 : 0.7));
    }
  }
}

TEST_CASE("where nothing presses, here or where a step leads, its matrix is that of any step") {
  Random random(8);
  for (const Energy kind : kEnergies)
    for (int sample = 0; sample < 50; ++sample) {
      const Law law = law_of(kind);
      const Axes pulled{{1.2 + random.uniform(0, 0.1), 0.02, 0}, {-0.02, 1.2 + random.uniform(0, 0.1), 0}};
      const Axes way{random_vector(random, 0.01), random_vector(random, 0.01)};
      const Hessian made = held_hessian(law, pulled, way), expected = positive_hessian(law, pulled);
      for (const Vec3d& v : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) {
        CHECK(length(made.warp * v - expected.warp * v) < 1e-9);
        CHECK(length(made.mixed * v - expected.mixed * v) < 1e-9);
        CHECK(length(made.weft * v - expected.weft * v) < 1e-9);
      }
    }
}

TEST_CASE("a rigid motion costs nothing, and a membrane's forces neither push nor turn the cloth") {
  Random random(4);
  for (const Energy kind : kEnergies)
    for (int sample = 0; sample < 100; ++sample) {
      const Law law = law_of(kind);
      State s(random, 0);
      const Eigen::Quaterniond turn = Eigen::Quaterniond::UnitRandom();
      const Vec3d shift = random_vector(random, 1);
      for (Vec3d& x : s.place) {
        const Eigen::Vector3d y = turn * Eigen::Vector3d(x.x, x.y, x.z);
        x = Vec3d{y.x(), y.y(), y.z()} + shift;
      }
      CHECK(std::abs(energy(law, s.deformation())) <
            1e-12);  // J/m²; strains of 1e-14 from places a metre away
      CHECK(length(stress(law, s.deformation()).warp) < 1e-10);
      const State strained(random, 1);
      const Axes f = strained.deformation(), rate = deformation(strained.rest, strained.velocity);
      const Axes elastic = stress(law, f), damping = damping_stress(law, f, rate);
      for (const Axes& p : {elastic, damping}) {
        const Corners all = forces(strained.rest, p);
        Vec3d sum, moment;
        double size = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          sum += all[i];
          moment += cross(strained.place[i], all[i]);
          size += length(all[i]);
        }
        CHECK(length(sum) < 1e-14 * size);
        CHECK(length(moment) < 1e-15 * size);  // places are within 4 cm of the origin
      }
    }
}

TEST_CASE("damping of membranes takes energy from every motion but a rigid one, at the rate of its blocks") {
  Random random(5);
  for (const Energy kind : kEnergies)
    for (int sample = 0; sample < 200; ++sample) {
      const Law law = law_of(kind);
      const State s(random, 1);
      const Axes f = s.deformation(), rate = deformation(s.rest, s.velocity);
      const Corners damping = forces(s.rest, damping_stress(law, f, rate));
      double power = 0;
      Eigen::Matrix<double, 9, 1> v;
      for (std::size_t i = 0; i < 3; ++i) {
        power += dot(damping[i], s.velocity[i]);
        for (int axis = 0; axis < 3; ++axis) v(3 * static_cast<int>(i) + axis) = s.velocity[i][axis];
      }
      CHECK(power <= 0);
      CHECK(power == doctest::Approx(-v.dot(dense(blocks(s.rest, damping_hessian(law, f))) * v)));
      const Vec3d spin = random_vector(random, 3);
      Corners turning;
      for (std::size_t i = 0; i < 3; ++i) turning[i] = cross(spin, s.place[i]);
      const Axes none = damping_stress(law, f, deformation(s.rest, turning));
      CHECK(length(none.warp) + length(none.weft) < 1e-12 * (law.stiffness.warp + law.stiffness.weft));
    }
}

TEST_CASE(
    "a step is damped by how its strain has changed: not where it only turns, by rates where it is short") {
  Random random(6);
  for (const Energy kind : kEnergies) {
    const Law law = law_of(kind);
    double worst = 0;
    for (int sample = 0; sample < 2000; ++sample) {
      const State start(random, 0.5), end(random, 2);
      const Axes f = end.deformation();
      const auto apart = [](const Axes& a, const Axes& b) {
        return length(a.warp - b.warp) + length(a.weft - b.weft);
      };
      const Corners turned = [&] {
        const Eigen::Quaterniond turn = Eigen::Quaterniond::UnitRandom();
        Corners all = end.place;
        for (Vec3d& x : all) {
          const Eigen::Vector3d y = turn * Eigen::Vector3d(x.x, x.y, x.z);
          x = {y.x(), y.y(), y.z()};
        }
        return all;
      }();
      const Axes there = deformation(end.rest, turned);
      CHECK(apart(step_stress(law, there, f, 1e3).stress, stress(law, there)) <
            1e-9 * (length(stress(law, there).warp) + law.stiffness.warp));
      constexpr double kShort = 1e-7;
      Corners later = end.place;
      for (std::size_t i = 0; i < 3; ++i) later[i] += kShort * end.velocity[i];
      const Axes after = deformation(end.rest, later), rate = deformation(end.rest, end.velocity);
      const Axes both = step_stress(law, after, f, 1 / kShort).stress, elastic = stress(law, after),
                 damping = damping_stress(law, after, rate);
      CHECK(apart({both.warp - elastic.warp, both.weft - elastic.weft}, damping) <
            1e-3 * (length(damping.warp) + length(damping.weft)) + 1e-6 * law.stiffness.warp);
      const Matrix9 k = dense(blocks(end.rest, step_stress(law, f, start.deformation(), 1e3).hessian));
      worst =
          std::min(worst, Eigen::SelfAdjointEigenSolver<Matrix9>(k, Eigen::EigenvaluesOnly).eigenvalues()(0) /
                              k.trace());
    }
    CHECK(worst > -1e-12);
  }
}

TEST_CASE(
    "small strains meet the moduli as given: uniaxial, biaxial, shear, Poisson's ratio, anisotropy of 100") {
  const double e = 1e-7;  // strain; the laws differ from each other by e, roundings are 1e-9 of it
  for (const Energy kind : kEnergies) {
    std::vector<Moduli> sheets = {moduli_of(kind)};
    if (kind != Energy::NeoHookean) sheets.insert(sheets.end(), {{2000, 20, 0.9, 15}, {20, 2000, 0.05, 15}});
    for (const Moduli& m : sheets) {
      const Law law{kind, Stiffness::of(m), 0};
      const Uniaxial warp(law, 1 + e), weft(law, 1 + e, false);
      CHECK(warp.force / e == doctest::Approx(m.warp).epsilon(1e-6).scale(0));
      CHECK(warp.contraction / e == doctest::Approx(m.poisson).epsilon(1e-6).scale(0));
      CHECK(weft.force / e == doctest::Approx(m.weft).epsilon(1e-6).scale(0));
      CHECK(weft.contraction / e == doctest::Approx(m.poisson * m.weft / m.warp).epsilon(1e-6).scale(0));
      // Both axes by e: strain is the compliance times stress.
      const Axes both = stress(law, {{1 + e, 0, 0}, {0, 1 + e, 0}});
      CHECK((both.warp.x - m.poisson * both.weft.y) / m.warp / e ==
            doctest::Approx(1).epsilon(1e-6).scale(0));
      CHECK((both.weft.y / m.weft - m.poisson * both.warp.x / m.warp) / e ==
            doctest::Approx(1).epsilon(1e-6).scale(0));
      const Axes sheared = stress(law, {{1, 0, 0}, {e, 1, 0}});
      CHECK(sheared.weft.x / e == doctest::Approx(m.shear).epsilon(1e-6).scale(0));
    }
  }
}

TEST_CASE("large stretches follow each law's closed form") {
  for (const double stretch : {0.8, 1.05, 1.2, 1.5}) {
    const Moduli m = moduli_of(Energy::Yarn);
    CHECK(Uniaxial(law_of(Energy::Green), stretch).force ==
          doctest::Approx(m.warp * stretch * (stretch * stretch - 1) / 2).epsilon(1e-9).scale(0));
    CHECK(Uniaxial(law_of(Energy::Yarn), stretch).force ==
          doctest::Approx(m.warp * (stretch - 1)).epsilon(1e-9).scale(0));
    // Stable neo-Hookean: the area of a pulled sheet. Source: newton-physics/newton, pull request 2654.
    const double nu = moduli_of(Energy::NeoHookean).poisson, square = stretch * stretch;
    const Uniaxial pulled(law_of(Energy::NeoHookean), stretch);
    CHECK(stretch * (1 - pulled.contraction) ==
          doctest::Approx(2 * square / (1 - nu + (1 + nu) * square)).epsilon(1e-9).scale(0));
  }
}

TEST_CASE("yarns that turn without a change of length meet shear alone, by the yarns' law and by Green's") {
  for (const double angle : {0.1, 0.5, 1.0}) {
    const Axes trellis{{1, 0, 0}, {std::sin(angle), std::cos(angle), 0}};
    const double expected = moduli_of(Energy::Yarn).shear * std::sin(angle) * std::sin(angle) / 2;
    CHECK(energy(law_of(Energy::Yarn), trellis) == doctest::Approx(expected).epsilon(1e-12).scale(0));
    CHECK(energy(law_of(Energy::Green), trellis) == doctest::Approx(expected).epsilon(1e-12).scale(0));
  }
}

TEST_CASE("a distorted patch whose rim is strained evenly is strained evenly inside") {
  const Axes strained{{1.08, 0.02, 0.3}, {-0.05, 0.97, 0.2}};
  for (const Energy kind : kEnergies) {
    const Law law = law_of(kind);
    const Patch patch(7);
    std::vector<Vec3d> exact;
    for (const MaterialPoint& p : patch.place)
      exact.push_back(p.warp * strained.warp + p.weft * strained.weft);
    for (std::size_t v = 0; v < exact.size(); ++v)
      if (patch.inner(v)) CHECK(length(patch.forces(law, exact)[v]) < 1e-13 * law.stiffness.warp);
    // And it is where Newton's method goes to.
    Random random(8);
    std::vector<Vec3d> x = exact;
    std::vector<int> unknown(x.size(), -1);
    int count = 0;
    for (std::size_t v = 0; v < x.size(); ++v)
      if (patch.inner(v)) {
        unknown[v] = 3 * count++;
        x[v] += random_vector(random, 5e-4);
      }
    for (int step = 0; step < 30; ++step) {
      Eigen::MatrixXd k = Eigen::MatrixXd::Zero(3 * count, 3 * count);
      for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
        const Axes f = deformation(patch.rests[t], patch.corners(t, x));
        const Matrix9 own = dense(blocks(patch.rests[t], hessian(law, f)));
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) {
            const int a = unknown[patch.triangles[t][static_cast<std::size_t>(i)]];
            const int b = unknown[patch.triangles[t][static_cast<std::size_t>(j)]];
            if (a >= 0 && b >= 0) k.block<3, 3>(a, b) += own.block<3, 3>(3 * i, 3 * j);
          }
      }
      const std::vector<Vec3d> f = patch.forces(law, x);
      Eigen::VectorXd right(3 * count);
      for (std::size_t v = 0; v < x.size(); ++v)
        if (unknown[v] >= 0) right.segment<3>(unknown[v]) << f[v].x, f[v].y, f[v].z;
      const Eigen::VectorXd way = k.ldlt().solve(right);
      for (std::size_t v = 0; v < x.size(); ++v)
        if (unknown[v] >= 0) x[v] += Vec3d{way(unknown[v]), way(unknown[v] + 1), way(unknown[v] + 2)};
    }
    double worst = 0;
    for (std::size_t v = 0; v < x.size(); ++v) worst = std::max(worst, length(x[v] - exact[v]));
    CHECK(worst < 1e-12);
  }
}

TEST_CASE("a table's membranes are the triangles, along the axes of the sheet") {
  const PatternSheet flat = pattern_sheet(Pattern::Irregular, 0.1, 8, 8);
  std::vector<Vec3d> turned;  // by a third of a turn about the diagonal: x -> y -> z
  for (const Vec3d& p : flat.position) turned.push_back({p.z, p.x, p.y});
  const Law law = law_of(Energy::Green);
  const ElementTable table = build_membranes({turned, flat.triangles, {0, 0.8, 0.6}}, law, 100);
  REQUIRE(table.size() == flat.triangles.size());
  CHECK(table.material.size() == 5 * table.size());
  CHECK(table.material[0] == doctest::Approx(law.stiffness.warp));
  // Stretched by 1.1 along warp, which lies at (0.8, 0.6) in the flat sheet.
  const auto stretched = [](const Vec3d& p) {
    return p + 0.1 * dot(p, Vec3d{0, 0.8, 0.6}) * Vec3d{0, 0.8, 0.6};
  };
  double area = 0;
  for (std::size_t t = 0; t < table.size(); ++t) {
    Corners x;
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(table.nodes_of(t)[i] == 100 + flat.triangles[t][i]);
      x[i] = stretched(turned[flat.triangles[t][i]]);
    }
    const Rest rest = rest_of(table, t);
    const Axes f = deformation(rest, x);
    CHECK(length(f.warp - Vec3d{0, 0.88, 0.66}) <
          1e-5);  // roundings of slopes to float, in triangles of 1 : 10
    CHECK(length(f.weft - Vec3d{0, -0.6, 0.8}) < 1e-5);
    area += rest.area;
  }
  CHECK(area == doctest::Approx(0.01).epsilon(1e-5).scale(0));
}
