#include "base/quaternion.hpp"

#include <cmath>

namespace weft {

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
          a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
          a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

Mat3 matrix_of(const Quaternion& q) {
  const auto [x, y, z, w] = q;
  return {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
          {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
          {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
}

Quaternion quaternion_of(const Mat3& m) {
  // Of the four, the largest component first (Shepperd 1978).
  const double xx = m.x.x, yy = m.y.y, zz = m.z.z;
  Quaternion q;
  if (xx + yy + zz > 0) {
    q = {m.z.y - m.y.z, m.x.z - m.z.x, m.y.x - m.x.y, 1 + xx + yy + zz};
  } else if (xx >= yy && xx >= zz) {
    q = {1 + xx - yy - zz, m.x.y + m.y.x, m.x.z + m.z.x, m.z.y - m.y.z};
  } else if (yy >= zz) {
    q = {m.x.y + m.y.x, 1 + yy - xx - zz, m.y.z + m.z.y, m.x.z - m.z.x};
  } else {
    q = {m.x.z + m.z.x, m.y.z + m.z.y, 1 + zz - xx - yy, m.y.x - m.x.y};
  }
  const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& part : q) part /= size;
  return q;
}

}  // namespace weft
