#include "player/hand.hpp"

#include <algorithm>
#include <cmath>

namespace weft::window {
namespace {

constexpr double kWindow = 0.05;  // over which the pointer's speed is taken [s]
constexpr double kCatchUp = 1.5;  // of that speed; only as fast, it would never make up for the window

}  // namespace

double distance(const Place& a, const Place& b) { return std::hypot(b.x - a.x, b.y - a.y); }

void Hand::follow(const Place& to, double at) {
  while (!moves_.empty() && moves_.front().at <= at - kWindow) moves_.pop_front();
  moves_.push_back({at, distance(pointer_, to)});
  pointer_ = to;
  double way = 0;
  for (const Move& move : moves_) way += move.way;
  speed_ = std::max(speed_, kCatchUp * way / kWindow);
}

Place Hand::after(double seconds) {
  const double left = distance(place_, pointer_);
  const double way = speed_ * seconds;
  if (left == 0 || way >= left) {
    place_ = pointer_;
    speed_ = 0;
  } else {
    place_.x += way / left * (pointer_.x - place_.x);
    place_.y += way / left * (pointer_.y - place_.y);
  }
  return place_;
}

}  // namespace weft::window
