// Vectors and blocks of the multigrid solver, read back, in the reference's terms.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>

#include "base/random.hpp"
#include "method/multigrid/reference/grid_operator.hpp"

namespace weft {

inline reference::Field field(const std::vector<Vec4f>& values) {
  reference::Field made;
  for (const Vec4f& v : values) made.push_back(v.xyz().to<double>());
  return made;
}

inline double largest(const reference::Field& values) {
  double most = 0;
  for (const Vec3d& v : values) most = std::max(most, length(v));
  return most;
}

/// The largest difference, as a part of the largest value.
inline double difference(const reference::Field& a, const reference::Field& b) {
  REQUIRE(a.size() == b.size());
  double most = 0;
  for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, length(a[n] - b[n]));
  return most / largest(b);
}

/// xx, yy, zz, yz; xz, xy.
inline reference::Sym3 sym3(const Vec4f& a, float b, float c) {
  const auto d = [](float x) { return static_cast<double>(x); };
  return {d(a.x), d(c), d(b), d(a.y), d(a.w), d(a.z)};
}

inline reference::Field random_field(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  reference::Field made(count);
  for (Vec3d& v : made) {
    const double a = random.uniform(-1, 1), b = random.uniform(-1, 1);
    v = {a, b, random.uniform(-1, 1)};
  }
  return made;
}

}  // namespace weft
