#include "scene/grab.hpp"

#include <algorithm>

namespace weft::scene {

bool active_at(const Grab& grab, double time) { return time > grab.start && !(grab.end && time > *grab.end); }

bool overlap(const Grab& a, const Grab& b) {
  return !(a.end && *a.end <= b.start) && !(b.end && *b.end <= a.start);
}

Vec3d target_at(const Grab& grab, double time) {
  const std::vector<GrabPoint>& path = grab.path;
  const auto next =
      std::find_if(path.begin(), path.end(), [&](const GrabPoint& point) { return point.time > time; });
  if (next == path.begin()) return path.front().point;
  if (next == path.end()) return path.back().point;
  const GrabPoint& from = *(next - 1);
  const double part = (time - from.time) / (next->time - from.time);
  return from.point * (1 - part) + next->point * part;
}

}  // namespace weft::scene
