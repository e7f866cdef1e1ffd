#include "scene/grab.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

namespace weft::scene {

bool active_at(const Grab& grab, double time) { return time > grab.start && !(grab.end && time > *grab.end); }

bool overlap(const Grab& a, const Grab& b) {
  return !(a.end && *a.end <= b.start) && !(b.end && *b.end <= a.start);
}

Hold hold_of(const Grab& grab) { return {grab.start, grab.end.value_or(HUGE_VAL)}; }

MostAtOnce most_at_once(std::vector<Hold> holds) {
  std::sort(holds.begin(), holds.end(), [](const Hold& a, const Hold& b) { return a.start < b.start; });
  std::priority_queue<double, std::vector<double>, std::greater<>> ends;
  MostAtOnce most;
  for (const Hold& hold : holds) {
    while (!ends.empty() && ends.top() <= hold.start) ends.pop();
    ends.push(hold.end);
    if (ends.size() > most.count) most = {ends.size(), hold.start};
  }
  return most;
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
