// The law of the air, and a flag that it makes flap: docs/air.md.
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>

#include "base/random.hpp"
#include "mesh/irregular_meshes.hpp"
#include "method/air_reference.hpp"
#include "rig.hpp"

using namespace weft;

namespace {

constexpr double kPi = 3.14159265358979323846;

Vec3d draw(Random& random) {
  const double a = random.uniform(-1, 1), b = random.uniform(-1, 1);
  return {a, b, random.uniform(-1, 1)};
}

// A strip of paper, clamped across the wind at one end.
constexpr double kLength = 0.2, kMass = 0.08, kBending = 4e-4,
                 kDensity = 1.225;  // [m], [kg/m²], [N·m], [kg/m³]

/// Its fastest growing small motion, exp(λ t) [1/s], by beam theory: with the law linearised about the flat strip,
///   m y.. + c (y. + U y') + B y'''' - (T y')' = 0,   c = ½ ρ C_L U,   T = ½ ρ C_F U² (L - x),
/// in cubic elements with slopes at their ends. Source: docs/air.md, equation 5.
std::complex<double> flutter_of(double speed) {
  constexpr int kElements = 40;
  const scene::Air air;
  const double c = 0.5 * kDensity * air.lift * speed, tension = 0.5 * kDensity * air.friction * speed * speed;
  const double h = kLength / kElements;
  constexpr int kAll = 2 * (kElements + 1), kFree = 2 * kElements;
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(kAll, kAll), damping = mass, stiffness = mass;
  // Gauss's four points: exact for the products of cubics.
  const double points[] = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526};
  const double weights[] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};
  for (int e = 0; e < kElements; ++e)
    for (int k = 0; k < 4; ++k) {
      const double s = (points[k] + 1) / 2, w = h * weights[k] / 2;
      const Eigen::Vector4d y{1 - 3 * s * s + 2 * s * s * s, h * s * (1 - s) * (1 - s), s * s * (3 - 2 * s),
                              h * s * s * (s - 1)};
      const Eigen::Vector4d slope =
          Eigen::Vector4d{6 * s * (s - 1), h * (1 - s) * (1 - 3 * s), 6 * s * (1 - s), h * s * (3 * s - 2)} /
          h;
      const Eigen::Vector4d curve =
          Eigen::Vector4d{12 * s - 6, h * (6 * s - 4), 6 - 12 * s, h * (6 * s - 2)} / (h * h);
      mass.block<4, 4>(2 * e, 2 * e) += w * kMass * y * y.transpose();
      damping.block<4, 4>(2 * e, 2 * e) += w * c * y * y.transpose();
      stiffness.block<4, 4>(2 * e, 2 * e) +=
          w *
          (kBending * curve * curve.transpose() +
           tension * (kLength - (e + s) * h) * slope * slope.transpose() + c * speed * y * slope.transpose());
    }
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(2 * kFree, 2 * kFree);  // the clamped end has no unknowns
  const Eigen::MatrixXd inverse = mass.bottomRightCorner(kFree, kFree).inverse();
  system.topRightCorner(kFree, kFree).setIdentity();
  system.bottomLeftCorner(kFree, kFree) = -inverse * stiffness.bottomRightCorner(kFree, kFree);
  system.bottomRightCorner(kFree, kFree) = -inverse * damping.bottomRightCorner(kFree, kFree);
  const Eigen::VectorXcd values = Eigen::EigenSolver<Eigen::MatrixXd>(system, false).eigenvalues();
  std::complex<double> fastest = values[0];
  for (const std::complex<double>& value : values)
    if (value.real() > fastest.real()) fastest = value;
  return {fastest.real(), std::abs(fastest.imag())};
}

/// The side places of the strip's free end in time, with so many cells along it [s], [m].
struct Trace {
  std::vector<double> time, place;
};
constexpr double kFrame = 0.0025;  // [s]
Trace flag_of(double speed, int cells, int substeps, int frames) {
  const double cell = kLength / cells;
  const auto number = [](double value) { return std::to_string(value); };
  // One more column of nodes is held than begins it: triangles between the two do not bend, and clamp it.
  reference::Simulation flag = simulation_of_text(R"("gravity": [0, 0, 0], "wind": {"velocity": [)" +
                                                  number(speed) + R"(, 0, 0]}, "air": {},
         "time": {"frame": 0.0025, "substeps": )" +
                                                  std::to_string(substeps) + R"(},
         "solver": {"kind": "multigrid", "residual": 1e-4}, "contact": {"method": "none"},
         "cloths": [{"grid": [)" + std::to_string(cells + 2) +
                                                  R"(, 3], "size": [)" + number(kLength + cell) + ", " +
                                                  number(2 * cell) + R"(], "density": 0.08, "bump": 1e-5,
           "fabric": {"warp": 5000, "shear": 2000, "bending_warp": 4e-4, "damping": 0},
           "pins": [{"box": {"min": [-1, -1, -1], "max": [)" +
                                                  number(-kLength / 2 + 0.6 * cell) + R"(, 1, 1]}}]}])");
  const std::size_t tip = 2 * static_cast<std::size_t>(cells + 2) - 1;  // in the middle row
  Trace trace;
  for (int frame = 0; frame < frames; ++frame) {
    REQUIRE(flag.advance_frame());
    trace.time.push_back(flag.time());
    trace.place.push_back(flag.positions()[tip].z);
  }
  return trace;
}

/// The growth of what swings between two sizes for the first time, by a straight line through the logarithms of its
/// extremes [1/s].
double growth_of(const Trace& trace, double from, double to) {
  std::vector<double> time, size;
  for (std::size_t i = 1; i + 1 < trace.place.size(); ++i) {
    const double before = std::abs(trace.place[i - 1]), now = std::abs(trace.place[i]);
    if (now > to) break;
    if (now < from || now <= before || now < std::abs(trace.place[i + 1])) continue;
    time.push_back(trace.time[i]);
    size.push_back(std::log(now));
  }
  REQUIRE(time.size() > 8);
  const Eigen::Map<Eigen::ArrayXd> t(time.data(), static_cast<Eigen::Index>(time.size())),
      s(size.data(), static_cast<Eigen::Index>(size.size()));
  return ((t - t.mean()) * (s - s.mean())).sum() / (t - t.mean()).square().sum();
}

/// Of the frames from `first` on, by where the trace rises through 0 [1/s].
double frequency_of(const Trace& trace, std::size_t first) {
  std::vector<double> rises;
  for (std::size_t i = first + 1; i < trace.place.size(); ++i) {
    const double a = trace.place[i - 1], b = trace.place[i];
    if (a < 0 && b >= 0) rises.push_back(trace.time[i] - kFrame * b / (b - a));
  }
  REQUIRE(rises.size() > 5);
  return static_cast<double>(rises.size() - 1) / (rises.back() - rises.front());
}

}  // namespace

TEST_CASE("the air's matrix has the law's force, gives no energy, and no part of it is above its bound") {
  Random random(3);
  const scene::Air air{1.3, 1.1, 1.6, 0.2};
  for (int k = 0; k < 2000; ++k) {
    const Vec3d normal = 0.1 * draw(random), slip = 20 * draw(random);
    const double area = length(normal) / 2;
    const Vec3d n = normal / length(normal), across = dot(slip, n) * n, along = slip - across;
    const Vec3d force = 0.5 * 1.3 * area *
                        ((1.1 * length(across) + 1.6 * length(along)) * across + 0.2 * length(slip) * along);
    const reference::Sym3 b = reference::air_on_triangle(air, normal, slip);
    CHECK(length(b * slip - force) < 1e-13 * length(force));
    const Vec3d other = draw(random);
    const double most = 0.5 * 1.3 * area * (1.1 + 1.6 + 0.2) * length(slip);
    CHECK(dot(other, b * other) >= 0);
    CHECK(dot(other, b * other) <= most * dot(other, other));
    // Either side, either sense.
    CHECK(length(reference::air_on_triangle(air, -1.0 * normal, slip) * slip - force) <
          1e-13 * length(force));
    CHECK(length(reference::air_on_triangle(air, normal, -1.0 * slip) * slip - force) <
          1e-13 * length(force));
  }
  const reference::Sym3 none = reference::air_on_triangle(air, {}, {1, 2, 3});
  CHECK(none.trace() == 0);
}

TEST_CASE("two triangulations of a sheet move alike in the wind, the more so the finer they are") {
  double apart[2];
  for (const int fine : {0, 1}) {
    const std::uint32_t cells = fine == 0 ? 8 : 16;
    const std::string nodes = std::to_string(cells + 1);
    std::array<std::array<Vec3d, 3>, 2> corners;
    for (const bool of_mesh : {false, true}) {
      const auto scene = scene::parse_scene(
          R"({"format": "weft-scene/1", "wind": {"velocity": [2, 3, 1]}, "air": {}, "time": {"substeps": 16},
              "solver": {"kind": "multigrid", "residual": 1e-4}, "contact": {"method": "none"}, "cloths": [{)" +
              std::string(of_mesh ? R"("mesh": "a.obj")"
                                  : R"("grid": [)" + nodes + ", " + nodes +
                                        R"(], "size": [0.4, 0.4], "plane": "xz")") +
              R"(, "density": 0.1, "fabric": {"warp": 500, "shear": 200, "bending_warp": 2e-3},
                 "pins": [{"box": {"min": [-0.21, -1, -1], "max": [-0.199, 1, 1]}}]}]})",
          "test.json");
      REQUIRE_OK(scene);
      auto simulation = reference::Simulation::create(
          *scene,
          {.cloths = {of_mesh ? jittered_sheet(cells + 1, cells + 1, 0.4, 0.4) : mesh::TriangleMesh{}}});
      REQUIRE_OK(simulation);
      for (int frame = 0; frame < 12; ++frame) REQUIRE(simulation->advance_frame());
      const std::vector<Vec3d>& x = simulation->positions();
      corners[of_mesh ? 1 : 0] = {x[cells], x[std::size_t{cells} * (cells + 1)], x.back()};
    }
    apart[fine] = 0;
    for (int corner = 0; corner < 3; ++corner)
      apart[fine] = std::max(apart[fine], length(corners[1][corner] - corners[0][corner]));
    MESSAGE(cells, " cells: corners ", apart[fine], " m apart");
  }
  CHECK(apart[1] < 0.01 * 0.4);
  CHECK(apart[1] < apart[0] / 2);  // of second order: a quarter; the jitter of the two meshes differs
}

TEST_CASE("a flag begins to flap as beam theory says, in a wind from where that says so") {
  // Without growth at 6 m/s, with it at 9.
  const std::complex<double> calm = flutter_of(6), windy = flutter_of(9);
  REQUIRE(calm.real() < -4);
  REQUIRE(windy.real() > 7);
  const Trace still = flag_of(6, 20, 8, 200);
  const auto largest = [](const Trace& trace, std::size_t first, std::size_t count) {
    const auto begin = trace.place.begin() + static_cast<std::ptrdiff_t>(first);
    return std::abs(*std::max_element(begin, begin + static_cast<std::ptrdiff_t>(count),
                                      [](double a, double b) { return std::abs(a) < std::abs(b); }));
  };
  CHECK(largest(still, 160, 40) < 0.5 * largest(still, 40, 40));
  double off[2];
  for (const int fine : {0, 1}) {
    const Trace trace = flag_of(9, fine == 0 ? 20 : 40, fine == 0 ? 4 : 8, 400);
    off[fine] = std::abs(growth_of(trace, 2e-5, 2e-3) / windy.real() - 1);
    MESSAGE(growth_of(trace, 2e-5, 2e-3), " 1/s by beam theory: ", windy.real());
    // It swings a few times while it grows: by its rises through 0, to a tenth.
    if (fine == 1) CHECK(std::abs(2 * kPi * frequency_of(trace, 40) / windy.imag() - 1) < 0.1);
  }
  CHECK(off[1] < 0.1);
  CHECK(off[1] < 0.7 * off[0]);
}

TEST_CASE("a flag flaps at the frequency of published experiments, whatever its cells") {
  // Raynaud and Mulleners (2026): waves 1.87 times as long as the flag run along it nearly as fast as the wind.
  const double published = 1 / 1.87, speed = 9;
  double found[2];
  for (const int fine : {0, 1}) {
    const Trace trace = flag_of(speed, fine == 0 ? 20 : 40, 8, 800);
    found[fine] = frequency_of(trace, 450) * kLength / speed;
    MESSAGE(found[fine], " wind lengths, published: ", published);
  }
  CHECK(std::abs(found[1] / published - 1) < 0.15);
  CHECK(std::abs(found[1] / found[0] - 1) < 0.03);
}
