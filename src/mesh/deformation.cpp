#include "mesh/deformation.hpp"

#include <algorithm>
#include <cmath>

namespace weft::mesh {

ShapeTimes::Moment ShapeTimes::at(double time) const {
  if (loops && !times.empty() && time >= times.back()) time = std::fmod(time, times.back());
  const auto next =
      static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin());
  if (next == times.size()) return {next, next, 0};
  const double before = next == 0 ? 0 : times[next - 1];
  return {next, next + 1, std::max(0.0, (time - before) / (times[next] - before))};
}

}  // namespace weft::mesh
