#include "element/tet/law.hpp"

#include <cmath>

#include "element/tet/jacobi.hpp"

namespace weft::tet {
namespace {

Mat3 minus(const Mat3& a, const Mat3& b) { return a + -1.0 * b; }

/// σ = 2 µ ε + λ tr ε
Mat3 hooke(const Law& law, const Mat3& strain) {
  return 2 * law.mu * strain + Mat3::identity(law.lambda * trace(strain));
}

/// Green's strain, but for a constant.
Mat3 green(const Mat3& f) { return 0.5 * (transposed(f) * f); }

}  // namespace

Law Law::of(Energy energy, double young, double poisson, double delay) {
  return {energy, young / (2 * (1 + poisson)), young * poisson / ((1 + poisson) * (1 - 2 * poisson)), delay};
}

Mat3 nearest_rotation(const Mat3& f) {
  const auto& [x, y, z] = f;
  Square<4> a = {{{x.x + y.y + z.z, z.y - y.z, x.z - z.x, y.x - x.y},
                  {z.y - y.z, x.x - y.y - z.z, x.y + y.x, z.x + x.z},
                  {x.z - z.x, x.y + y.x, y.y - x.x - z.z, y.z + z.y},
                  {y.x - x.y, z.x + x.z, y.z + z.y, z.z - x.x - y.y}}};
  const Square<4> v = diagonalise(a);
  std::size_t best = 0;
  for (std::size_t k = 1; k < 4; ++k)
    if (a[k][k] > a[best][best]) best = k;
  const double w = v[0][best];
  const Vec3d u{v[1][best], v[2][best], v[3][best]};
  return Mat3::identity(w * w - dot(u, u)) + 2 * Mat3::outer(u, u) + 2 * w * Mat3::cross(u);
}

double energy(const Law& law, const Mat3& f) {
  if (law.energy == Energy::NeoHookean) {
    const double grown = dot(f.x, cross(f.y, f.z)) - 1;
    return law.mu * (0.5 * (contraction(f, f) - 3) - grown) + 0.5 * (law.lambda + law.mu) * grown * grown;
  }
  const Mat3 r = nearest_rotation(f), away = minus(f, r);
  const double grown = contraction(r, f) - 3;
  return law.mu * contraction(away, away) + 0.5 * law.lambda * grown * grown;
}

Mat3 stress(const Law& law, const Mat3& f) {
  if (law.energy == Energy::NeoHookean) {
    const double grown = dot(f.x, cross(f.y, f.z)) - 1;
    return law.mu * f + ((law.lambda + law.mu) * grown - law.mu) * cofactor(f);
  }
  const Mat3 r = nearest_rotation(f);
  return 2 * law.mu * minus(f, r) + law.lambda * (contraction(r, f) - 3) * r;
}

Mat3 damping_stress(const Law& law, const Mat3& f, const Mat3& rate) {
  return law.delay * (f * hooke(law, symmetric_part(transposed(f) * rate)));
}

Rest Rest::of(const std::array<Vec3d, 4>& corners) {
  const Vec3d b = corners[1] - corners[0], c = corners[2] - corners[0], d = corners[3] - corners[0];
  const double six = dot(cross(b, c), d);
  Rest rest;
  rest.volume = std::abs(six) / 6;
  rest.slope[1] = cross(c, d) / six;
  rest.slope[2] = cross(d, b) / six;
  rest.slope[3] = cross(b, c) / six;
  rest.slope[0] = -1.0 * (rest.slope[1] + rest.slope[2] + rest.slope[3]);
  return rest;
}

Mat3 deformation(const Rest& rest, const Corners& corners) {
  Mat3 f{};
  for (std::size_t k = 1; k < 4; ++k) f += Mat3::outer(corners[k] - corners[0], rest.slope[k]);
  return f;
}

Corners forces(const Rest& rest, const Mat3& stress) {
  Corners made;
  for (std::size_t k = 1; k < 4; ++k) {
    made[k] = -rest.volume * (stress * rest.slope[k]);
    made[0] -= made[k];
  }
  return made;
}

CornerPull corner_pull(const Law& law, const Rest& rest, const Mat3& f, const Mat3& start, double rate,
                       std::size_t corner) {
  const Vec3d& n = rest.slope[corner];
  const double square = dot(n, n), delays = law.delay * rate;
  Mat3 total = stress(law, f), block;
  if (law.energy == Energy::NeoHookean) {
    const Vec3d c = cofactor(f) * n;
    block = Mat3::identity(law.mu * square) + (law.lambda + law.mu) * Mat3::outer(c, c);
  } else {
    const Vec3d turned = nearest_rotation(f) * n;
    block = Mat3::identity(2 * law.mu * square) + law.lambda * Mat3::outer(turned, turned);
  }
  if (delays > 0) {
    total += delays * (f * hooke(law, minus(green(f), green(start))));
    const Vec3d along = f * n;
    block +=
        delays * (law.mu * square * (f * transposed(f)) + (law.mu + law.lambda) * Mat3::outer(along, along));
  }
  return {-rest.volume * (total * n), rest.volume * block};
}

}  // namespace weft::tet
