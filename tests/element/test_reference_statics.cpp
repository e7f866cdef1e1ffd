// The reference at rest against closed forms.
#include <algorithm>

#include "closed_forms/elastica.hpp"
#include "element/reference/equilibrium.hpp"
#include "reference_sheets.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

const double kPi = std::acos(-1.0);
constexpr double kGravity = 9.81;  // [m/s²]

/// The root of the mean square over all nodes of how far they are from where they should be [m].
double mean_error(const std::vector<Vec3d>& x, const std::vector<Vec3d>& exact) {
  double sum = 0;
  for (std::size_t v = 0; v < x.size(); ++v) sum += dot(x[v] - exact[v], x[v] - exact[v]);
  return std::sqrt(sum / static_cast<double>(x.size()));
}

/// A smooth shape of a stretched unit square, none of whose points is at rest.
Vec3d shape_at(double s, double t) {
  const double swell = std::sin(kPi * s) * std::sin(kPi * t);
  return {1.2 * s + 0.05 * swell, 1.1 * t + 0.1 * s - 0.04 * swell, 0.2 * swell};
}
membrane::Axes slopes_at(double s, double t) {
  const double by_s = kPi * std::cos(kPi * s) * std::sin(kPi * t),
               by_t = kPi * std::sin(kPi * s) * std::cos(kPi * t);
  return {{1.2 + 0.05 * by_s, 0.1 - 0.04 * by_s, 0.2 * by_s}, {0.05 * by_t, 1.1 - 0.04 * by_t, 0.2 * by_t}};
}

/// The load that holds the square in that shape: minus the divergence of its stress [N/m²].
Vec3d load_at(const membrane::Law& law, double s, double t) {
  const double step = 1e-5;
  const auto at = [&](double ds, double dt) { return stress(law, slopes_at(s + ds, t + dt)); };
  return (at(-step, 0).warp - at(step, 0).warp + at(0, -step).weft - at(0, step).weft) / (2 * step);
}

/// A strip of this weight by area [N/m²], length [m] and bending modulus [N·m], clamped before x = 0. Its own weight
/// stretches it by up to a thousandth.
Sheet heavy_strip(const PatternSheet& pattern, double weight, double length, double modulus) {
  Sheet sheet = cloth_of(pattern);
  sheet.warp = {1, 0, 0};
  sheet.held = held_before_zero(pattern.position);
  sheet.membrane.stiffness = Stiffness::of(Moduli::isotropic(1000 * weight * length, 0));
  sheet.bending = Stiffness::of(Moduli::isotropic(modulus, 0));
  sheet.density = weight / kGravity;
  return sheet;
}

/// A heavy strip clamped level, whose weight stretches it by up to a thousandth: how far its tip is from that of an
/// elastica that stretches alike, by its length.
double cantilever_error(Pattern kind, int along, double g) {
  constexpr double kLength = 0.2, kModulus = 2e-5;  // [m], [N·m]
  const PatternSheet pattern = pattern_sheet(kind, kLength, along, along / 6, 1);
  std::vector<Vec3d> start = pattern.position;
  // The load rises in steps, so that every start is near its end.
  for (double load = std::min(g, 3.0);; load = std::min(g, 3 * load)) {
    const double weight = load * kModulus / std::pow(kLength, 3);
    Sheet sheet = heavy_strip(pattern, weight, kLength, kModulus);
    sheet.gravity = {0, 0, -kGravity};
    const auto found = equilibrium(SheetEnergy(sheet), start);
    REQUIRE_MESSAGE(found, (found ? "" : found.error().message));
    CHECK(found->stable);
    start = found->position;
    if (load == g) break;
  }
  double drop = 0;
  int count = 0;
  for (std::size_t v = 0; v < start.size(); ++v)
    if (pattern.position[v].x > kLength - 1e-9) {
      drop -= start[v].z;
      ++count;
    }
  return std::abs(drop / count / kLength - Elastica(g, 1e-3).drop);
}

}  // namespace

TEST_CASE("cloth hung by its edge stretches by w L² / 2 E, however far") {
  // Yarns' force is E times their extension at every strain.
  for (const Pattern kind : kPatterns) {
    std::array<double, 3> error{};
    for (std::size_t level = 0; level < error.size(); ++level) {
      const int along = 6 << level;
      const PatternSheet pattern = pattern_sheet(kind, 1, along, along / 2);
      Sheet sheet = cloth_of(pattern);
      const double modulus = 20, weight = 4;  // [N/m], [N/m²]: strains of up to a fifth
      sheet.warp = {1, 0, 0};
      sheet.held = held_before_zero(pattern.position);
      sheet.membrane.stiffness = Stiffness::of(Moduli::isotropic(modulus, 0));
      sheet.density = weight / kGravity;
      sheet.gravity = {kGravity, 0, 0};
      const auto found = equilibrium(SheetEnergy(sheet), pattern.position);
      REQUIRE_MESSAGE(found, (found ? "" : found.error().message));
      std::vector<Vec3d> exact;
      for (const Vec3d& p : pattern.position)
        exact.push_back({p.x + weight / modulus * p.x * (1 - p.x / 2), p.y, 0});
      error[level] = mean_error(found->position, exact) / (weight / (2 * modulus));
    }
    MESSAGE(name_of(kind) << ": errors " << error[0] << ", " << error[1] << ", " << error[2]
                          << " of the elongation, orders " << order_of(error[0], error[1]) << ", "
                          << order_of(error[1], error[2]));
    CHECK(order_of(error[0], error[2]) / 2 > 1.5);  // nearer to the second order than to the first
  }
}

TEST_CASE("cloth that sags between two edges is an elastic catenary, to the second order of its triangles") {
  // At arc length s from the middle at rest and tension H there: x = H s/E + H/w asinh(w s/H),
  // z = w s²/(2 E) + H/w ((1 + (w s/H)²)^(1/2) - 1).
  constexpr double kSpan = 0.8, kModulus = 40, kWeight = 4;  // of a length of 1 [m]; [N/m]; [N/m²]
  const auto reach = [&](double h, double s) {
    return h * s / kModulus + h / kWeight * std::asinh(kWeight * s / h);
  };
  double low = 1e-3, high = 100;  // H [N/m]
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2;
    (reach(middle, 0.5) > kSpan / 2 ? high : low) = middle;
  }
  const auto rise = [&](double s) {
    return kWeight * s * s / (2 * kModulus) + low / kWeight * (std::hypot(1, kWeight * s / low) - 1);
  };
  for (const Pattern kind : {Pattern::Alternating, Pattern::Irregular}) {
    std::array<double, 2> error{};
    for (std::size_t level = 0; level < error.size(); ++level) {
      const PatternSheet pattern = pattern_sheet(kind, 1, level == 0 ? 12 : 24, level == 0 ? 4 : 8);
      Sheet sheet = cloth_of(pattern);
      sheet.warp = {1, 0, 0};
      sheet.membrane.stiffness = Stiffness::of(Moduli::isotropic(kModulus, 0));
      sheet.bending = {};
      sheet.density = kWeight / kGravity;
      sheet.gravity = {0, 0, -kGravity};
      for (const Vec3d& p : pattern.position) sheet.held.push_back(p.x < 1e-9 || p.x > 1 - 1e-9 ? 1 : 0);
      sheet.place = [&](std::uint32_t v, double) {
        const Vec3d& p = pattern.position[v];
        return Placed{{p.x < 0.5 ? 0 : kSpan, p.y, 0}, {}};
      };
      std::vector<Vec3d> start, exact;  // a fold in the middle; the catenary
      for (const Vec3d& p : pattern.position) {
        start.push_back({kSpan * p.x, p.y, -0.3 * std::min(p.x, 1 - p.x)});
        const double s = p.x - 0.5;
        exact.push_back({kSpan / 2 + std::copysign(reach(low, std::abs(s)), s), p.y, rise(s) - rise(0.5)});
      }
      const auto found = equilibrium(SheetEnergy(sheet), start);
      REQUIRE_MESSAGE(found, (found ? "" : found.error().message));
      CHECK(found->stable);
      error[level] = mean_error(found->position, exact);
      MESSAGE(name_of(kind) << ": error " << error[level] << " m of a sag of " << rise(0.5) << " m, "
                            << found->report.steps << " steps, " << found->report.positive_steps
                            << " with the positive matrix");
    }
    CHECK(order_of(error[0], error[1]) > 1.5);
  }
}

TEST_CASE(
    "a membrane under the load that belongs to a given shape takes it, to the second order of its "
    "triangles") {
  for (const membrane::Energy energy : kEnergies)
    for (const Pattern kind : {Pattern::Alternating, Pattern::Irregular}) {
      std::array<double, 3> error{};
      for (std::size_t level = 0; level < error.size(); ++level) {
        const int along = 6 << level;
        const PatternSheet pattern = pattern_sheet(kind, 1, along, along);
        Sheet sheet = cloth_of(pattern, energy);
        sheet.warp = {1, 0, 0};
        sheet.bending = {};
        const SheetEnergy areas(sheet);
        for (std::uint32_t v = 0; v < sheet.rest.size(); ++v) {
          sheet.held.push_back(pattern.inside(v, 1e-9) ? 0 : 1);
          sheet.load.push_back(areas.mass()[v] / sheet.density *
                               load_at(sheet.membrane, sheet.rest[v].x, sheet.rest[v].y));
        }
        sheet.place = [&](std::uint32_t v, double) {
          return Placed{shape_at(pattern.position[v].x, pattern.position[v].y), {}};
        };
        std::vector<Vec3d> exact;
        for (const Vec3d& p : pattern.position) exact.push_back(shape_at(p.x, p.y));
        const auto found = equilibrium(SheetEnergy(sheet), exact);
        REQUIRE_MESSAGE(found, (found ? "" : found.error().message));
        error[level] = mean_error(found->position, exact);
      }
      MESSAGE("energy " << static_cast<int>(energy) << ", " << name_of(kind) << ": errors " << error[0]
                        << ", " << error[1] << ", " << error[2] << " m, orders "
                        << order_of(error[0], error[1]) << ", " << order_of(error[1], error[2]));
      CHECK(order_of(error[0], error[2]) / 2 > 1.5);  // nearer to the second order than to the first
    }
}

TEST_CASE(
    "a heavy cantilever's drop converges to the elastica's, on every pattern by at least the first order") {
  for (const double g : {1.0, 10.0, 100.0})
    for (const Pattern kind : kPatterns) {
      const double coarse = cantilever_error(kind, 12, g), fine = cantilever_error(kind, 24, g);
      MESSAGE("G = " << g << ", " << name_of(kind) << ": errors " << coarse << ", " << fine
                     << " of the length, order " << order_of(coarse, fine));
      CHECK(order_of(coarse, fine) > 1);
    }
}

TEST_CASE("Newton's method squares what is wrong in each step") {
  // Nodes off by 1e-4 of the length, then by some 1e-8, 1e-16: three steps at most, by the exact Hessian alone. The
  // sheet is bent, stretched and sheared, so that every part of that matters.
  for (const membrane::Energy energy : kEnergies) {
    const PatternSheet pattern = pattern_sheet(Pattern::Irregular, 1, 8, 5);
    Sheet sheet = cloth_of(pattern, energy);
    sheet.held = held_before_zero(pattern.position);
    sheet.bending = Stiffness::of({0.2, 0.1, 0.2, 0.06});
    sheet.gravity = {2, 3, -kGravity};
    const SheetEnergy whole(sheet);
    auto found = equilibrium(whole, pattern.position, {1e-8});
    REQUIRE_MESSAGE(found, (found ? "" : found.error().message));
    Random random(8);
    for (Vec3d& p : found->position) p += random_vector(random, 1e-4);
    const auto again = equilibrium(whole, found->position, {1e-8});
    REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
    CHECK(again->report.steps <= 3);
    CHECK(again->report.positive_steps == 0);
  }
}

TEST_CASE("a sheet that nothing holds up finds no rest, and says how far it is from it") {
  const PatternSheet pattern = pattern_sheet(Pattern::Irregular, 1, 4, 3);
  Sheet sheet = cloth_of(pattern);
  sheet.gravity = {0, 0, -kGravity};
  const auto found = equilibrium(SheetEnergy(sheet), pattern.position, {1e-6, 5});
  REQUIRE(!found);
  CHECK(found.error().kind == ErrorKind::Diverged);
  CHECK(found.error().message ==
        "After 5 steps Newton's method leaves a residual of 9.81 m/s², above 1e-06 m/s².");
}

TEST_CASE(
    "a strip that stands on its clamp is at rest in its plane, and stable there below Greenhill's weight") {
  for (const double part : {0.98, 1.02}) {  // Greenhill 1881: G = 7.8373
    constexpr double kLength = 0.2, kModulus = 2e-5;
    const PatternSheet pattern = pattern_sheet(Pattern::Alternating, kLength, 24, 4, 1);
    const double weight = part * 7.8373 * kModulus / std::pow(kLength, 3);
    Sheet sheet = heavy_strip(pattern, weight, kLength, kModulus);
    sheet.gravity = {-kGravity, 0, 0};
    const auto found = equilibrium(SheetEnergy(sheet), pattern.position);
    REQUIRE_MESSAGE(found, (found ? "" : found.error().message));
    CHECK(found->stable == (part < 1));
  }
}
