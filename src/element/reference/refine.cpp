#include "element/reference/refine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft::reference {

Result<Refined> refine(const std::function<Result<double>(int level)>& value, double tolerance, int most) {
  constexpr double kLeastOrder = 0.5, kMostOrder = 2, kSafety = 1.25;
  Refined last;
  double before = std::numeric_limits<double>::quiet_NaN();  // the change of the level before
  last.error = std::numeric_limits<double>::infinity();
  for (int level = 0; level < most; ++level) {
    WEFT_TRY(next, value(level));
    const double change = std::abs(next - last.value);
    last.value = next;
    last.levels = level + 1;
    if (level >= 2) {
      last.order = std::log2(before / change);
      last.error = last.order < kLeastOrder
                       ? std::numeric_limits<double>::infinity()
                       : kSafety * change / (std::exp2(std::min(last.order, kMostOrder)) - 1);
      if (last.error <= tolerance) return last;
    }
    before = change;
  }
  return make_error(
      ErrorKind::Diverged,
      "After %d levels a refined value has an error of %.3g, above %.3g, and changes by the order %.3g.",
      last.levels, last.error, tolerance, last.order);
}

}  // namespace weft::reference
