#include "element/tet/hessian.hpp"

#include <algorithm>

namespace weft::tet {
namespace {

/// Twice the cosine's least part: two stretches that sum to less turn as if to this.
constexpr double kLeastSum = 0.1;

std::array<double, 3> numbers(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// Without negative eigenvalues.
Square<3> positive_part(const Square<3>& a) {
  const auto [axes, values] = principal(matrix_of(a));
  const auto at_least_zero = [](double value) { return std::max(value, 0.0); };
  const Mat3 kept{
      {at_least_zero(values[0]), 0, 0}, {0, at_least_zero(values[1]), 0}, {0, 0, at_least_zero(values[2])}};
  return square_of(axes * (kept * transposed(axes)));
}

/// What resists where two axes turn against each other, and where both shear; neither is negative.
void set_axes(Hessian& made, std::size_t p, std::size_t q, double twist, double shear) {
  made.straight[p][q] = made.straight[q][p] = (shear + twist) / 2;
  made.crossed[p][q] = made.crossed[q][p] = (shear - twist) / 2;
}

template <class Each>
void for_each_axis(const Each& each) {
  for (std::size_t k = 0; k < 3; ++k) each(k, (k + 1) % 3, (k + 2) % 3);
}

Hessian neo_hookean(const Law& law, const std::array<double, 3>& s) {
  const double bulk = law.lambda + law.mu, pressure = bulk * (s[0] * s[1] * s[2] - 1) - law.mu;
  Hessian made;
  for (std::size_t p = 0; p < 3; ++p) made.stretch[p][p] = law.mu;
  for_each_axis([&](std::size_t k, std::size_t p, std::size_t q) {
    const double across = s[p] * s[q];
    made.stretch[k][k] += bulk * across * across;
    const double both = bulk * (s[q] * s[k]) * (s[k] * s[p]) + pressure * s[k];
    made.stretch[p][q] = made.stretch[q][p] = both;
    set_axes(made, p, q, std::max(0.0, law.mu + pressure * s[k]), std::max(0.0, law.mu - pressure * s[k]));
  });
  made.stretch = positive_part(made.stretch);
  return made;
}

Hessian corotated(const Law& law, const std::array<double, 3>& s) {
  const double turning = law.lambda * (s[0] + s[1] + s[2] - 3) - 2 * law.mu;
  Hessian made;
  for (std::size_t p = 0; p < 3; ++p)
    for (std::size_t q = 0; q < 3; ++q) made.stretch[p][q] = law.lambda + (p == q ? 2 * law.mu : 0);
  for_each_axis([&](std::size_t, std::size_t p, std::size_t q) {
    const double twist = 2 * law.mu + 2 * turning / std::max(s[p] + s[q], kLeastSum);
    set_axes(made, p, q, std::max(0.0, twist), 2 * law.mu);
  });
  return made;
}

/// How the energy grows with each stretch [Pa].
std::array<double, 3> principal_stress(const Law& law, const std::array<double, 3>& s) {
  std::array<double, 3> made{};
  const double pressure = (law.lambda + law.mu) * (s[0] * s[1] * s[2] - 1) - law.mu;
  const double grown = law.lambda * (s[0] + s[1] + s[2] - 3);
  for_each_axis([&](std::size_t k, std::size_t p, std::size_t q) {
    made[k] = law.energy == Energy::NeoHookean ? law.mu * s[k] + pressure * s[p] * s[q]
                                               : 2 * law.mu * (s[k] - 1) + grown;
  });
  return made;
}

template <class Combine>
Hessian combined(const Hessian& a, const Hessian& b, const Combine& combine) {
  Hessian made;
  for (std::size_t p = 0; p < 3; ++p)
    for (std::size_t q = 0; q < 3; ++q) {
      made.stretch[p][q] = combine(a.stretch[p][q], b.stretch[p][q]);
      made.straight[p][q] = combine(a.straight[p][q], b.straight[p][q]);
      made.crossed[p][q] = combine(a.crossed[p][q], b.crossed[p][q]);
    }
  return made;
}

}  // namespace

Frame frame_of(const Mat3& f) {
  const Mat3 r = nearest_rotation(f);
  const auto [axes, stretches] = principal(symmetric_part(transposed(r) * f));
  return {r * axes, axes, stretches};
}

Hessian operator+(const Hessian& a, const Hessian& b) {
  return combined(a, b, [](double p, double q) { return p + q; });
}
Hessian operator*(double s, const Hessian& a) {
  return combined(a, a, [&](double p, double) { return s * p; });
}

Hessian positive_hessian(const Law& law, const Frame& frame) {
  return law.energy == Energy::NeoHookean ? neo_hookean(law, frame.stretches)
                                          : corotated(law, frame.stretches);
}

Hessian held_hessian(const Law& law, const Frame& frame, const Mat3& way) {
  Hessian made = positive_hessian(law, frame);
  const std::array<double, 3>& s = frame.stretches;
  const std::array<double, 3> now = principal_stress(law, s);
  const Square<3> led = square_of(transposed(frame.u) * (way * frame.v));
  std::array<double, 3> then = now;
  for (std::size_t p = 0; p < 3; ++p)
    for (std::size_t q = 0; q < 3; ++q) then[p] += made.stretch[p][q] * led[q][q];
  for_each_axis([&](std::size_t, std::size_t p, std::size_t q) {
    if (std::min(now[p] + now[q], then[p] + then[q]) >= 0) return;
    const double twist = std::abs(then[p] + then[q]) / std::max(s[p] + s[q], kLeastSum);
    set_axes(made, p, q, std::min(twist, 2 * law.mu + law.lambda), made.straight[p][q] + made.crossed[p][q]);
  });
  return made;
}

Hessian damping_hessian(const Law& law, const Frame& frame) {
  const std::array<double, 3>& s = frame.stretches;
  const double mu = law.delay * law.mu, lambda = law.delay * law.lambda;
  Hessian made;
  for (std::size_t p = 0; p < 3; ++p)
    for (std::size_t q = 0; q < 3; ++q) {
      made.stretch[p][q] = (lambda + (p == q ? 2 * mu : 0)) * s[p] * s[q];
      if (p == q) continue;
      made.straight[p][q] = mu * s[p] * s[p];
      made.crossed[p][q] = mu * s[p] * s[q];
    }
  return made;
}

Mat3 times(const Frame& frame, const Hessian& hessian, const Mat3& change) {
  const Square<3> a = square_of(transposed(frame.u) * (change * frame.v));
  Square<3> b{};
  for (std::size_t p = 0; p < 3; ++p)
    for (std::size_t q = 0; q < 3; ++q) {
      b[p][p] += hessian.stretch[p][q] * a[q][q];
      if (p != q) b[p][q] = hessian.straight[p][q] * a[p][q] + hessian.crossed[p][q] * a[q][p];
    }
  return frame.u * (matrix_of(b) * transposed(frame.v));
}

Mat3 block(const Frame& frame, const Hessian& hessian, const Rest& rest, std::size_t row,
           std::size_t column) {
  const Mat3 turned = transposed(frame.v);
  const std::array<double, 3> b = numbers(turned * rest.slope[row]), a = numbers(turned * rest.slope[column]);
  Square<3> made{};
  for (std::size_t p = 0; p < 3; ++p)
    for (std::size_t q = 0; q < 3; ++q) {
      made[p][q] += hessian.stretch[p][q] * b[p] * a[q];
      if (p == q) continue;
      made[p][p] += hessian.straight[p][q] * b[q] * a[q];
      made[p][q] += hessian.crossed[p][q] * b[q] * a[p];
    }
  return rest.volume * (frame.u * (matrix_of(made) * transposed(frame.u)));
}

}  // namespace weft::tet
