#include "weft/placement.hpp"

#include <cmath>

#include "base/quaternion.hpp"
#include "base/result.hpp"

namespace weft {
namespace {

constexpr double kRounding = 1e-3;  // of lengths and products of columns: what three written decimals leave

}  // namespace

Result<Placement> Placement::from_matrix(std::span<const double, 16> columns) {
  for (std::size_t k = 0; k < 16; ++k)
    if (!std::isfinite(columns[k]))
      return input_error("Number %zu of the matrix is not finite: %g.", k, columns[k]);
  if (columns[3] != 0 || columns[7] != 0 || columns[11] != 0 || columns[15] != 1)
    return input_error("The last row of the matrix is (%g, %g, %g, %g); that of a placement is (0, 0, 0, 1).",
                       columns[3], columns[7], columns[11], columns[15]);
  const auto column = [&](std::size_t k) {
    return Vec3d{columns[4 * k], columns[4 * k + 1], columns[4 * k + 2]};
  };
  for (std::size_t a = 0; a < 3; ++a) {
    if (const double size = length(column(a)); !(std::abs(size - 1) <= kRounding))
      return input_error("Column %zu of the matrix has length %g; a placement does not scale, to %g.", a,
                         size, kRounding);
    for (std::size_t b = 0; b < a; ++b)
      if (const double product = dot(column(a), column(b)); !(std::abs(product) <= kRounding))
        return input_error(
            "Columns %zu and %zu of the matrix have the product %g; a placement does not shear, to %g.", b, a,
            product, kRounding);
  }
  if (dot(column(0), cross(column(1), column(2))) < 0)
    return input_error("The matrix mirrors: its determinant is -1; that of a placement is 1.");
  return Placement{column(3), quaternion_of(transposed({column(0), column(1), column(2)}))};
}

}  // namespace weft
