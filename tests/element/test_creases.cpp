// Bends that stay, against the closed forms of a bar that yields and hardens.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "closed_forms/pattern_sheet.hpp"
#include "element/hinge/creases.hpp"
#include "rolled_sheet.hpp"

using namespace weft;
using namespace weft::hinge;

namespace {

constexpr double kBending = 2e-5;  // N·m
const Stiffness kEven = Stiffness::of(Moduli::isotropic(kBending, 0));

/// A bar under a curvature: what it keeps of it.
struct Bar {
  Yield law;
  double plastic = 0, spent = 0;

  double elastic(double curvature) const { return curvature - plastic; }
  void bend(double curvature) {
    const double over = std::abs(elastic(curvature)) - law.curvature - law.hardening * spent;
    if (over <= 0) return;
    const double kept = over / (1 + law.hardening);
    plastic += std::copysign(kept, elastic(curvature));
    spent += kept;
  }
};

/// Has only the facets away from the rim resist, near which there are fewer angles than curvatures; their area [m²].
double keep_inner(const PatternSheet& sheet, Plate& plate) {
  double area = 0;
  for (std::size_t t = 0; t < plate.facets.size(); ++t) {
    const auto& nodes = sheet.triangles[t];
    if (std::all_of(nodes.begin(), nodes.end(),
                    [&](std::uint32_t v) { return sheet.inside(v, 2.5 * sheet.cell); }))
      area += sheet.area_of(t);
    else
      plate.facets[t].stiffness = plate.facets[t].curving = {};
  }
  REQUIRE(area > 0.2 * sheet.length * sheet.width);
  return area;
}

}  // namespace

TEST_CASE("a facet keeps of a curvature what brings it back to the line of yielding, no more") {
  for (const double hardening : {0.0, 0.5, 3.0})
    for (const double spent : {0.0, 4.0}) {
      const Yield law{10, hardening};
      const double edge = 10 + hardening * spent;
      CHECK(law.kept(edge, spent) == 0);
      const double kept = law.kept(edge + 7, spent);
      // B (K - kept) is the moment at which it yields after that.
      CHECK(edge + 7 - kept == doctest::Approx(10 + hardening * (spent + kept)).epsilon(1e-14).scale(0));
      // The slope of the moment beyond the yield: B h / (1 + h).
      CHECK(std::abs(7 - kept - 7 * hardening / (1 + hardening)) < 1e-13);
    }
}

TEST_CASE(
    "a sheet rolled forth and back has the energy and the moments of a bar that yields, on every pattern") {
  for (const Pattern pattern : kPatterns)
    for (const double degrees : {0.0, 35.0, 90.0})
      for (const double hardening : {0.0, 0.25}) {
        CAPTURE(name_of(pattern));
        CAPTURE(degrees);
        CAPTURE(hardening);
        const double direction = degrees * std::acos(-1.0) / 180;
        const PatternSheet sheet = pattern_sheet(pattern, 0.12, 12, 12);  // cells of 1 cm
        Plate plate = build_plate({sheet.position, sheet.triangles}, kEven);
        const double inner = keep_inner(sheet, plate);
        const Yield law{0.8, hardening};
        std::vector<Crease> creases(plate.facets.size());
        Bar bar{law};
        double worst = 0;
        for (const double curvature :
             {0.5, 1.2, 2.4, 1.6, 0.0, -1.0, -2.4, 0.0, 3.0}) {  // 0.03 rad a cell at most
          const std::vector<double> bend = bends(plate, rolled(sheet, curvature, direction));
          yield(plate, law, bend, creases);
          bar.bend(curvature);
          const double exact = inner * kBending * std::pow(bar.elastic(curvature), 2) / 2;
          const double most = inner * kBending * 3.0 * 3.0 / 2;
          worst = std::max(worst, std::abs(energy(plate, bend, creases) - exact) / most);
          double off = 0, size = 0;
          for (std::size_t f = 0; f < creases.size(); ++f) {
            if (plate.facets[f].curving == Mat3{}) continue;
            off = std::max(off, std::abs(creases[f].spent - bar.spent));
            size = std::max(size, bar.spent);
          }
          CHECK(off <= 1e-3 * std::max(size, 1.0));
        }
        // Angles of 0.03 rad are within (0.03)² of linear in curvature, as the energy is of their squares.
        CHECK(worst < 1e-3);
      }
}

TEST_CASE("the work of a closed cycle of bending is the area of its loop, and all of it is lost") {
  // Between ±k1 a bar that does not harden has a parallelogram of height 2 B ky and width 2 (k1 - ky).
  const PatternSheet sheet = pattern_sheet(Pattern::Irregular, 0.12, 12, 12);
  Plate plate = build_plate({sheet.position, sheet.triangles}, kEven);
  const double inner = keep_inner(sheet, plate);
  const Yield law{0.8, 0};
  const double largest = 2.4;
  std::vector<Crease> creases(plate.facets.size());
  double work = 0, lost = 0, first_energy = 0;
  std::vector<double> before(plate.hinges.size()), moment_before(plate.hinges.size());
  constexpr int kSteps = 2000;  // of a quarter
  int step = -kSteps;           // from 0 to k1, where the cycle begins
  for (; step <= 4 * kSteps; ++step) {
    const double phase = static_cast<double>(step) / kSteps;  // k1 at 0, -k1 at 2
    const double curvature = phase < 0 ? largest * (1 + phase) : largest * (std::abs(phase - 2) - 1);
    const std::vector<double> bend = bends(plate, rolled(sheet, curvature, 0));
    const double trial = energy(plate, bend, creases);
    yield(plate, law, bend, creases);
    const std::vector<double> moment = moments(plate, bend, creases);
    if (step == 0) first_energy = energy(plate, bend, creases);
    if (step > 0) {
      lost += trial - energy(plate, bend, creases);
      for (std::size_t h = 0; h < bend.size(); ++h)
        work += (moment[h] + moment_before[h]) / 2 * (bend[h] - before[h]);
    }
    before = bend;
    moment_before = moment;
  }
  const double loop = inner * 2 * kBending * law.curvature * 2 * (largest - law.curvature);
  const std::vector<double> bend = bends(plate, rolled(sheet, largest, 0));
  MESSAGE("work " << work << " J, loop " << loop << ", lost " << lost);
  CHECK(work > 0);
  CHECK(work == doctest::Approx(loop).epsilon(2e-3).scale(0));  // 0.024 rad a cell
  // A step gives away more than its part of the loop by half the energy of its overshoot: by 1/kSteps of it in all.
  CHECK(lost == doctest::Approx(work).epsilon(2e-3).scale(0));
  CHECK(energy(plate, bend, creases) ==
        doctest::Approx(first_energy).epsilon(1e-6).scale(0));  // the cycle is closed
}

TEST_CASE(
    "yielding takes energy from any bends of any creases, ends on the line of yielding, and ends at once") {
  Random random(3);
  for (int sample = 0; sample < 200; ++sample) {
    const PatternSheet sheet =
        pattern_sheet(Pattern::Irregular, 0.03, 3, 3, 0, 0, static_cast<std::uint64_t>(sample));
    const Stiffness d = Stiffness::of({9e-5, 2e-5, 0.3, 1.5e-5});
    const Plate plate = build_plate({sheet.position, sheet.triangles}, d);
    const Yield law{random.uniform(0, 60), random.uniform(0, 2)};
    std::vector<double> bend(plate.hinges.size());
    for (double& b : bend) b = random.uniform(-1, 1);
    std::vector<Crease> creases(plate.facets.size());
    for (Crease& crease : creases)
      crease = {{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}, random.uniform(0, 5)};
    const std::vector<Crease> first = creases;
    const double before = energy(plate, bend, creases);
    yield(plate, law, bend, creases);
    const double after = energy(plate, bend, creases);
    CHECK(after <= before * (1 + 1e-14));
    const std::vector<Crease> once = creases;
    yield(plate, law, bend, creases);
    double again = 0;
    for (std::size_t f = 0; f < creases.size(); ++f) {
      again = std::max(again, length(creases[f].parts - once[f].parts));
      CHECK(once[f].spent >= first[f].spent);
    }
    CHECK(again < 1e-13);
  }
}

TEST_CASE("what creases take off the moments is a matrix of their parts, and the energy's slope") {
  Random random(4);
  for (const Pattern pattern : kPatterns) {
    const PatternSheet sheet = pattern_sheet(pattern, 0.05, 5, 4);
    const Plate plate =
        build_plate({sheet.position, sheet.triangles}, Stiffness::of({9e-5, 2e-5, 0.3, 1.5e-5}));
    std::vector<double> bend(plate.hinges.size());
    for (double& b : bend) b = random.uniform(-1, 1);
    std::vector<Crease> creases(plate.facets.size());
    for (Crease& crease : creases)
      crease.parts = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const std::vector<double> moment = moments(plate, bend, creases);
    std::vector<double> sum = moments(plate, bend);
    CHECK(sum == moments(plate, bend, std::vector<Crease>(plate.facets.size())));  // to the bit
    std::uint32_t row = 0, column = 0;
    for (const Coupling& c : crease_couplings(plate)) {
      CHECK((c.row > row || (c.row == row && c.column >= column)));
      row = c.row;
      column = c.column;
      sum[c.row] += c.entry * creases[c.column / 3].parts[static_cast<int>(c.column % 3)];
    }
    double size = 0, off = 0, slope_off = 0;
    for (std::size_t h = 0; h < bend.size(); ++h) {
      size = std::max(size, std::abs(moment[h]));
      off = std::max(off, std::abs(sum[h] - moment[h]));
      std::vector<double> more = bend, less = bend;  // the energy is quadratic: differences are exact
      more[h] += 1e-2;
      less[h] -= 1e-2;
      slope_off = std::max(
          slope_off,
          std::abs((energy(plate, more, creases) - energy(plate, less, creases)) / 2e-2 - moment[h]));
    }
    CHECK(off < 1e-13 * size);
    CHECK(slope_off < 1e-10 * size);
  }
}
