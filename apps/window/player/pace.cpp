#include "player/pace.hpp"

#include <algorithm>

namespace weft::window {
namespace {

constexpr double kSlack = 5e-4;  // a display ticks a little early or late [s]
constexpr double kMostLate = 2;  // frames

}  // namespace

void Pace::pass(double seconds, double frame) {
  const double late = late_ + seconds;
  late_ = std::min(late, kMostLate * frame);
  dropped_ += late - late_;
}

bool Pace::due(double frame) const { return late_ + kSlack >= frame; }

double Pace::until_due(double frame) const { return std::max(0.0, frame - kSlack - late_); }

}  // namespace weft::window
