// Strips of cloth that bend, against the elastica: four triangulations, one modulus.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/random.hpp"
#include "closed_forms/elastica.hpp"
#include "closed_forms/pattern_sheet.hpp"
#include "statics.hpp"

using namespace weft;

namespace {

const double kPi = std::acos(-1.0);
constexpr double kLength = 0.2;    // [m]
constexpr double kModulus = 2e-5;  // B [N·m]
constexpr int kAlong = 24, kAcross = 5;

/// A strip clamped at x <= 0, and beyond its length if it goes on there. Its membrane is so soft that triangles bend
/// freely and so stiff that a load `weight` [N/m²] stretches it by less than a thousandth.
Statics strip(const PatternSheet& sheet, const Moduli& bending, double weight,
              const Vec3d& warp = {1, 0, 0}) {
  std::vector<std::uint8_t> held;
  const bool goes_on = sheet.position.back().x > sheet.length + 1e-9;
  for (const Vec3d& p : sheet.position)
    held.push_back(p.x < 1e-9 || (goes_on && p.x > sheet.length - 1e-9) ? 1 : 0);
  const membrane::Law law{membrane::Energy::Green,
                          Stiffness::of(Moduli::isotropic(1000 * weight * kLength, 0)), 0};
  return {sheet.position, sheet.triangles, law, Stiffness::of(bending), held, warp};
}

void weigh(Statics& cloth, const PatternSheet& sheet, double weight, const Vec3d& down = {0, 0, -1}) {
  for (std::size_t t = 0; t < sheet.triangles.size(); ++t)
    for (const std::uint32_t v : sheet.triangles[t]) cloth.load[v] += weight * sheet.area_of(t) / 3 * down;
}

/// A load on the free end, evenly along its width.
void pull_end(Statics& cloth, const PatternSheet& sheet, double force) {
  double share = 0;
  for (std::size_t v = 0; v < sheet.position.size(); ++v) {
    const Vec3d& p = sheet.position[v];
    if (p.x < kLength - 1e-9) continue;
    const bool corner = p.y < 1e-9 || p.y > sheet.width - 1e-9;
    cloth.load[v].z = corner ? -0.5 : -1;
    share -= cloth.load[v].z;
  }
  for (Vec3d& f : cloth.load) f *= force / share;
}

/// The sheet with a node in every `every`-th triangle that is free, at a hundredth of its height over one of its edges:
/// such a triangle falls into two and a sliver.
PatternSheet pricked(PatternSheet sheet, std::size_t every) {
  for (std::size_t t = 0; t < sheet.triangles.size(); t += every) {
    const auto [a, b, c] = sheet.triangles[t];
    const Vec3d inside = 0.496 * sheet.position[a] + 0.494 * sheet.position[b] + 0.01 * sheet.position[c];
    if (inside.x < sheet.cell) continue;
    const auto n = static_cast<std::uint32_t>(sheet.position.size());
    sheet.position.push_back(inside);
    sheet.triangles[t] = {a, b, n};
    sheet.triangles.push_back({b, c, n});
    sheet.triangles.push_back({c, a, n});
  }
  return sheet;
}

/// How far the free end is below the clamp, on average.
double tip_drop(const Statics& cloth, const PatternSheet& sheet) {
  double sum = 0;
  int count = 0;
  for (std::size_t v = 0; v < sheet.position.size(); ++v)
    if (sheet.position[v].x > sheet.length - 1e-9) {
      sum -= cloth.x[v].z;
      ++count;
    }
  return sum / count;
}

}  // namespace

TEST_CASE("the elastica stands below the load at which a column buckles by its weight, and falls above") {
  constexpr double kAlmostUpright = 1e-4;  // rad; Greenhill 1881: 7.8373
  const double right_angle = std::acos(0.0);
  CHECK(Elastica(7.7, 0, right_angle - kAlmostUpright).reach < 0.01);
  CHECK(Elastica(8.0, 0, right_angle - kAlmostUpright).reach > 0.1);
}

TEST_CASE("the elastica by shooting has the published drops of a heavy cantilever") {
  for (const auto& [g, drop] : {std::pair{1.0, 0.12347}, {2.0, 0.23851}, {10.0, 0.70020}, {100.0, 0.93752}})
    CHECK(Elastica(g).drop == doctest::Approx(drop).epsilon(2e-5).scale(0));
}

TEST_CASE("a strip under a small load at its end is a beam of the given modulus, whatever its triangles") {
  struct Cut {
    Moduli bending;
    Vec3d warp;
  };
  const Moduli stiff_warp{kModulus, kModulus / 10, 0.2, kModulus / 10};
  const Moduli soft_weft{10 * kModulus, kModulus, 0.2, kModulus};
  // Bent at 45° to its axes a strip is as soft as its compliance there: (1/B1 + 1/B2 - 2 ν/B1 + 1/D33) / 4.
  Moduli oblique{2, 1, 0.2, 0.6};
  const double compliance = (1 / 2.0 + 1 - 2 * 0.2 / 2 + 1 / 0.6) / 4 * kModulus;
  for (double* m : {&oblique.warp, &oblique.weft, &oblique.shear}) *m *= compliance;
  for (const Cut& cut : {Cut{stiff_warp, {1, 0, 0}},
                         {soft_weft, {0, 1, 0}},
                         {oblique, {1, 1, 0}},
                         {Moduli::isotropic(kModulus, 0.3), {1, 0, 0}}})
    for (const Pattern pattern : kPatterns) {
      const PatternSheet sheet = pattern_sheet(pattern, kLength, kAlong, 2, 1);
      Statics cloth = strip(sheet, cut.bending, 0.05, cut.warp);
      const double force = 1e-3 * 3 * kModulus * sheet.width / (kLength * kLength);  // for a drop of L / 1000
      pull_end(cloth, sheet, force);
      REQUIRE(cloth.solve(1e-5 * force));
      const double ratio = 1e-3 * kLength / tip_drop(cloth, sheet);
      MESSAGE(name_of(pattern) << ": effective modulus " << ratio << " B, " << cloth.steps << " steps");
      CHECK(ratio == doctest::Approx(1).epsilon(0.02).scale(0));
    }
}

TEST_CASE(
    "a heavy cantilever drops as the elastica does, whatever its triangles, by angles and by the quadratic "
    "form") {
  for (const bool isometric : {false, true})
    for (const Pattern pattern : kPatterns) {
      const PatternSheet sheet = pattern_sheet(pattern, kLength, kAlong, kAcross, 1);
      std::vector<Vec3d> start = sheet.position;
      for (const double g : {1.0, 3.0, 10.0, 30.0, 100.0}) {
        const double weight = g * kModulus / std::pow(kLength, 3);
        Statics cloth = strip(sheet, Moduli::isotropic(kModulus, 0), weight);
        if (isometric) cloth.use_isometric_bending(sheet.position);
        weigh(cloth, sheet, weight);
        cloth.x = start;
        REQUIRE(cloth.solve(1e-9 * weight * kLength * kLength));
        start = cloth.x;
        const double exact = Elastica(g).drop, drop = tip_drop(cloth, sheet) / kLength;
        MESSAGE(name_of(pattern) << std::string(isometric ? ", quadratic" : "") << ", G = " << g << ": "
                                 << drop << " for " << exact << ", " << 100 * (drop / exact - 1) << " %, "
                                 << cloth.steps << " steps");
        CHECK(drop == doctest::Approx(exact).epsilon(0.02).scale(0));
      }
    }
}

TEST_CASE("a cantilever of a mesh with slivers drops as the elastica does") {
  for (const Pattern pattern : kPatterns) {
    const PatternSheet sheet = pattern_sheet(pattern, kLength, kAlong, kAcross, 1);
    const PatternSheet thin = pricked(sheet, 29);
    const std::size_t pricks = thin.position.size() - sheet.position.size();
    for (const double g : {1.0, 10.0}) {
      const double weight = g * kModulus / std::pow(kLength, 3);
      Statics cloth = strip(thin, Moduli::isotropic(kModulus, 0), weight);
      const auto slivers =
          static_cast<std::size_t>(std::count_if(cloth.plate.facets.begin(), cloth.plate.facets.end(),
                                                 [](const hinge::Facet& facet) { return facet.sliver; }));
      CHECK(slivers == pricks);
      weigh(cloth, thin, weight);
      REQUIRE(cloth.solve(1e-9 * weight * kLength * kLength));
      const double exact = Elastica(g).drop, drop = tip_drop(cloth, thin) / kLength;
      MESSAGE(name_of(pattern) << ", " << pricks << " slivers, G = " << g << ": " << 100 * (drop / exact - 1)
                               << " %, " << cloth.steps << " steps");
      CHECK(drop == doctest::Approx(exact).epsilon(0.02).scale(0));
    }
  }
}

TEST_CASE("a cantilever's drop converges with its triangles, on irregular ones by at least the first order") {
  std::array<double, 2> error{};
  for (std::size_t level = 0; level < 2; ++level) {
    const int along = level == 0 ? 12 : 36;
    const PatternSheet sheet = pattern_sheet(Pattern::Irregular, kLength, along, along / 6, 1);
    const double weight = kModulus / std::pow(kLength, 3);
    Statics cloth = strip(sheet, Moduli::isotropic(kModulus, 0), weight);
    weigh(cloth, sheet, weight);
    REQUIRE(cloth.solve(1e-9 * weight * kLength * kLength));
    error[level] = std::abs(tip_drop(cloth, sheet) / kLength / Elastica(1).drop - 1);
  }
  MESSAGE("errors " << error[0] << ", " << error[1]);
  CHECK(error[1] < error[0] / 3);
}

TEST_CASE("a strip whose ends are turned until they meet is a circle with the energy of one") {
  // Both ends are held in one place with one tangent: a moment of 2 pi B / L bends the strip, and nothing else.
  for (const Pattern pattern : kPatterns) {
    const PatternSheet sheet = pattern_sheet(pattern, kLength, kAlong, kAcross, 1, 1);
    Statics cloth = strip(sheet, Moduli::isotropic(kModulus, 0), 0.5);
    const double radius = kLength / (2 * kPi);
    Random random(3);
    for (std::size_t v = 0; v < sheet.position.size(); ++v) {
      const Vec3d& p = sheet.position[v];
      const double r = radius + (cloth.held[v] != 0 ? 0 : random.uniform(-0.1, 0.1) * sheet.cell);
      cloth.x[v] = {r * std::sin(p.x / radius), p.y, radius - r * std::cos(p.x / radius)};
      if (cloth.held[v] != 0) cloth.x[v] = {p.x < 1e-9 ? p.x : p.x - kLength, p.y, 0};
    }
    REQUIRE(cloth.solve(1e-9 * kModulus / kLength));
    const double exact = 2 * kPi * kPi * kModulus * sheet.width / kLength;
    double worst = 0;
    for (const Vec3d& p : cloth.x)
      if (p.z > 0.1 * radius) worst = std::max(worst, std::abs(std::hypot(p.x, p.z - radius) / radius - 1));
    MESSAGE(name_of(pattern) << ": energy " << cloth.bending_energy(cloth.x) / exact
                             << " of a circle's, radii within " << 100 * worst << " %, " << cloth.steps
                             << " steps");
    CHECK(cloth.bending_energy(cloth.x) == doctest::Approx(exact).epsilon(0.02).scale(0));
    CHECK(worst < 0.02);
  }
}

TEST_CASE("a standing strip buckles under its weight at G = 7.8373") {
  // Greenhill 1881: 9/4 of the square of the first zero of the Bessel function of order -1/3.
  for (const Pattern pattern : kPatterns)
    for (const double part : {0.98, 1.02}) {
      CAPTURE(name_of(pattern));
      const PatternSheet sheet = pattern_sheet(pattern, kLength, kAlong, kAcross, 1);
      const double weight = part * 7.8373 * kModulus / std::pow(kLength, 3);
      Statics cloth = strip(sheet, Moduli::isotropic(kModulus, 0), weight);
      weigh(cloth, sheet, weight, {-1, 0, 0});
      REQUIRE(cloth.solve(1e-9 * weight * kLength * kLength));
      CHECK(cloth.stable() == (part < 1));
    }
}

TEST_CASE(
    "cloth hung by its edge stretches under its weight by w L² / 2 E, with an error of the second order") {
  std::array<double, 2> error{};
  for (std::size_t level = 0; level < 2; ++level) {
    const int along = level == 0 ? 8 : 24;
    const PatternSheet sheet = pattern_sheet(Pattern::Irregular, kLength, along, along / 2);
    const double weight = 0.5;
    Statics cloth = strip(sheet, Moduli::isotropic(kModulus, 0), weight);
    const double modulus = cloth.membranes.law.stiffness.warp,
                 small = 1e-3;  // of the load: strains of at most 1e-6
    weigh(cloth, sheet, small * weight, {1, 0, 0});
    REQUIRE(cloth.solve(1e-9 * small * weight * kLength * kLength));
    const double most = small * weight * kLength * kLength / (2 * modulus);
    for (std::size_t v = 0; v < sheet.position.size(); ++v) {
      const double part = sheet.position[v].x / kLength;
      const double way = cloth.x[v].x - sheet.position[v].x;
      error[level] +=
          std::pow(way / most - part * (2 - part), 2) / static_cast<double>(sheet.position.size());
    }
    error[level] = std::sqrt(error[level]);
  }
  MESSAGE("root mean square errors " << error[0] << ", " << error[1] << " of the elongation");
  CHECK(error[1] < error[0] / 7);  // a third of the size: a ninth, but for the nodes' random places
}
