// Kirchhoff's rod against what is known of it: the elastica, two critical loads, small twist.
#include "closed_forms/kirchhoff_rod.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "closed_forms/elastica.hpp"

using namespace weft;

namespace {

/// How far the end goes across if a hundred-thousandth of the weight pulls that way, by what it is of a weight that is
/// too small to buckle anything: a part of which buckling makes much.
double amplified(double load, const Vec3d& main, const Vec3d& across, const RodSection& section) {
  constexpr double kSmall = 1e-5;
  const double alone = dot(KirchhoffRod(0.01, across, section).tip, across) / 0.01;
  return dot(KirchhoffRod(load, main + kSmall * across, section).tip, across) / (kSmall * load * alone);
}

/// The load at which a rod buckles, by Southwell's plot (1932): near it what is amplified goes as 1/(1 - (G/G*)²).
double buckling_load(double near, const Vec3d& main, const Vec3d& across, const RodSection& section) {
  const double low = 0.98 * near, high = 0.99 * near;
  const double a = 1 / amplified(low, main, across, section), b = 1 / amplified(high, main, across, section);
  return std::sqrt(low * low + a / (a - b) * (high * high - low * low));
}

}  // namespace

TEST_CASE("a Kirchhoff rod that its weight does not twist is the elastica, across and within its plane") {
  for (const double load : {1.0, 10.0, 100.0}) {
    CAPTURE(load);
    const Elastica exact(load);
    const Vec3d across = KirchhoffRod(load, {0, -1, 0}, {50, 2, 0.01}).tip;
    CHECK(length(across - Vec3d{0, -exact.drop, exact.reach}) < 1e-7);
    const Vec3d within = KirchhoffRod(3 * load, {1, 0, 0}, {3, 2, 0.01}).tip;  // three times as stiff there
    CHECK(length(within - Vec3d{exact.drop, 0, exact.reach}) < 1e-7);
  }
}

TEST_CASE("a Kirchhoff rod buckles under Greenhill's load where it stands, and under Timoshenko's on edge") {
  CHECK(buckling_load(7.8373, {0, 0, -1}, {0, 1, 0}, {50, 2}) == doctest::Approx(7.8373).epsilon(1e-4));
  for (const double twist :
       {0.5, 2.0}) {  // 12.85 sqrt(GJ/EI) [Timoshenko and Gere 1961, table 6-3], no bending in plane
    const double load = 12.85 * std::sqrt(twist);
    CHECK(buckling_load(load, {-1, 0, 0}, {0, 1, 0}, {1e7, twist}) == doctest::Approx(load).epsilon(1e-3));
  }
}

TEST_CASE("a clamp that keeps the width straight takes from a rod's twist what Vlasov's length is of it") {
  // Slight weight aslant: the end turns by the integral of the moment along it, M3 = (c - 1) K1 K2 to second order,
  // so its way across changes by third order. A rod that may not twist at all goes where each plane has it alone.
  const Vec3d aslant{std::sqrt(0.5), -std::sqrt(0.5), 0};
  const Vec3d rigid = KirchhoffRod(0.4, aslant, {10, 1e6}).tip;
  CHECK(rigid.x == doctest::Approx(Elastica(0.4 / 10 * std::sqrt(0.5)).drop).epsilon(1e-3));
  const Vec3d free = KirchhoffRod(20, aslant, {10, 2}).tip;
  double before = length(KirchhoffRod(20, aslant, {10, 1e6}).tip - free);
  CHECK(before > 0.05);
  for (const double warping : {0.2, 0.05, 0.0125}) {  // nearer to the free rod, in proportion at last
    const double off = length(KirchhoffRod(20, aslant, {10, 2, warping}).tip - free);
    CHECK(off < before);
    before = off;
  }
  CHECK(before / length(KirchhoffRod(20, aslant, {10, 2, 0.00625}).tip - free) ==
        doctest::Approx(2).epsilon(0.05));
}
