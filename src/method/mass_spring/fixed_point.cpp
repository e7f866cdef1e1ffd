#include "method/mass_spring/fixed_point.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace weft {

ForceFixedPoint force_fixed_point(const Springs& springs, std::uint32_t vertex_count) {
  std::vector<std::uint32_t> valence(vertex_count, 0);
  double limit = 0;
  for (const Spring spring : springs) {
    ++valence[spring.node_a];
    ++valence[spring.node_b];
    limit = std::max(limit, static_cast<double>(spring.stiffness) * static_cast<double>(spring.rest_length));
  }
  const double most = valence.empty() ? 0.0 : *std::max_element(valence.begin(), valence.end());
  if (most == 0 || limit == 0) return {};
  constexpr double kDirection = 1 + 1.0 / (1 << 20);  // no component of a direction is larger: see the header
  const double bound =
      (2147483648.0 - most / 2) / (static_cast<double>(static_cast<float>(limit)) * kDirection * most);
  int exponent = 0;
  std::frexp(bound, &exponent);  // bound = f 2^exponent with f in [1/2, 1)
  double scale = std::ldexp(1.0, exponent - 1);
  if (scale >= bound) scale /= 2;
  return {static_cast<float>(limit), static_cast<float>(scale)};
}

}  // namespace weft
