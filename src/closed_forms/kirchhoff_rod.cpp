#include "closed_forms/kirchhoff_rod.hpp"

#include <cmath>

#include "base/mat3.hpp"

namespace weft {
namespace {

constexpr int kSteps = 400;      // along the rod
constexpr int kLoadSteps = 100;  // of the weight
constexpr double kTurn = 1e-6;   // for differences [rad]

/// The directors as rows.
using Frame = Mat3;

/// Turned by |angle| about it (Rodrigues).
Frame turned(const Frame& frame, const Vec3d& angle) {
  const double a = length(angle);
  const double first = a > 1e-9 ? std::sin(a) / a : 1, second = a > 1e-9 ? (1 - std::cos(a)) / (a * a) : 0.5;
  const auto turn = [&](const Vec3d& v) {
    const Vec3d once = cross(angle, v);
    return v + first * once + second * cross(angle, once);
  };
  return {turn(frame.x), turn(frame.y), turn(frame.z)};
}

struct Rod {
  double load;
  Vec3d down;
  RodSection section;

  struct Rate {
    Vec3d turn, moment, way;  // by r = 1 - s, from the free end
  };
  Rate rate(const Frame& d, const Vec3d& moment, double r) const {
    const double warped = section.warping > 0 ? 1 - std::exp((r - 1) / section.warping) : 1;
    const Vec3d turn = dot(moment, d.x) * d.x + dot(moment, d.y) / section.in_plane * d.y +
                       dot(moment, d.z) * warped / section.twist * d.z;
    return {-turn, load * r * cross(d.z, down), -d.z};
  }

  struct End {
    Frame frame;
    Vec3d place;
  };
  /// From the free end to the clamp. A fourth-order method of Runge and Kutta on rotations (Munthe-Kaas 1998) would
  /// need commutators; the midpoint rule is symmetric, so Richardson's extrapolation of two step lengths is of order 4.
  End at_clamp(const Frame& tip, int steps) const {
    const double h = 1.0 / steps;
    Frame d = tip;
    Vec3d m, x;
    for (int i = 0; i < steps; ++i) {
      const double r = i * h;
      const Rate first = rate(d, m, r);
      const Frame middle = turned(d, h / 2 * first.turn);
      const Rate half = rate(middle, m + h / 2 * first.moment, r + h / 2);
      d = turned(d, h * half.turn);
      m = m + h * half.moment;
      x = x + h * half.way;
    }
    return {d, x};
  }
  /// How far the frame at the clamp is turned from x, y and z, to first order.
  static Vec3d off(const Frame& d) {
    return 0.5 * (cross({1, 0, 0}, d.x) + cross({0, 1, 0}, d.y) + cross({0, 0, 1}, d.z));
  }
  /// The frame of the free end for which that is nothing.
  Frame solved(Frame tip, int steps) const {
    for (int round = 0; round < 30; ++round) {
      const Vec3d wrong = off(at_clamp(tip, steps).frame);
      if (length(wrong) < 1e-12) break;
      const auto slope = [&](const Vec3d& axis) {
        return 1 / (2 * kTurn) *
               (off(at_clamp(turned(tip, kTurn * axis), steps).frame) -
                off(at_clamp(turned(tip, -kTurn * axis), steps).frame));
      };
      const Mat3 slopes = transposed({slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})});
      tip = turned(tip, -(inverse(slopes) * wrong));
    }
    return tip;
  }
};

}  // namespace

KirchhoffRod::KirchhoffRod(double load, const Vec3d& down, const RodSection& section) {
  Frame coarse{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Rod rod{0, down, section};
  for (int part = 1; part <= kLoadSteps; ++part) {
    rod.load = load * part / kLoadSteps;
    coarse = rod.solved(coarse, kSteps);
  }
  const Frame fine = rod.solved(coarse, 2 * kSteps);
  const Vec3d once = rod.at_clamp(coarse, kSteps).place, twice = rod.at_clamp(fine, 2 * kSteps).place;
  tip = -1.0 / 3 * (4 * twice - once);
}

}  // namespace weft
