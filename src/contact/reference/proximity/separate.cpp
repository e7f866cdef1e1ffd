#include "contact/reference/proximity/separate.hpp"

#include <algorithm>
#include <limits>

namespace weft::reference {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// Two sides about a plane that is moved along the direction.
class AboutPlane {
 public:
  AboutPlane(const BothSides& sides, double apart) : sides_(sides), apart_(apart) {}
  std::uint32_t count() const { return sides_.count_a + sides_.count_b; }
  bool on_a(std::uint32_t k) const { return k < sides_.count_a; }
  bool moves(std::uint32_t k) const { return sides_.mass[k] > 0; }
  /// Where the plane begins to move the vertex.
  double bend(std::uint32_t k) const { return sides_.along[k] + (on_a(k) ? -0.5 : 0.5) * apart_; }
  double shift(std::uint32_t k, double plane) const {
    if (!moves(k)) return 0;
    const double beyond = plane - bend(k);
    return on_a(k) ? std::max(0.0, beyond) : std::min(0.0, beyond);
  }
  /// The shifts times the masses [kg m]: straight between two bends, and never falling.
  double moment(double plane) const {
    double sum = 0;
    for (std::uint32_t k = 0; k < count(); ++k) sum += sides_.mass[k] * shift(k, plane);
    return sum;
  }

 private:
  const BothSides& sides_;
  double apart_;
};

/// Where the moment is zero.
double balanced(const AboutPlane& sides) {
  double below = -kNowhere, above = kNowhere;
  for (std::uint32_t k = 0; k < sides.count(); ++k) {
    if (!sides.moves(k)) continue;
    const double bend = sides.bend(k);
    if (sides.moment(bend) <= 0)
      below = std::max(below, bend);
    else
      above = std::min(above, bend);
  }
  if (below == -kNowhere) return above;
  if (above == kNowhere) return below;
  const double lack = -sides.moment(below), surplus = sides.moment(above);
  return below + (above - below) * (lack / (lack + surplus));
}

}  // namespace

double BothSides::apart() const {
  const auto middle = along.begin() + count_a;
  return *std::min_element(along.begin(), middle) - *std::max_element(middle, middle + count_b);
}

std::array<double, 4> separated(const BothSides& sides, double apart) {
  const AboutPlane about(sides, apart);
  double least = -kNowhere, most = kNowhere;  // before what stays
  for (std::uint32_t k = 0; k < about.count(); ++k) {
    if (about.moves(k) || !sides.stays[k]) continue;
    if (about.on_a(k))
      most = std::min(most, about.bend(k));
    else
      least = std::max(least, about.bend(k));
  }
  const double plane = std::max(least, std::min(most, balanced(about)));
  std::array<double, 4> shifts{};
  for (std::uint32_t k = 0; k < about.count(); ++k) shifts[k] = about.shift(k, plane);
  return shifts;
}

}  // namespace weft::reference
