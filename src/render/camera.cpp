#include "render/camera.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace weft::render {
namespace {

constexpr double kAzimuth = 32 * kDegree;    // to the right of the z axis
constexpr double kElevation = 16 * kDegree;  // above the horizon
constexpr double kMargin = 1.06;

Vec3d normalized(const Vec3d& v) { return v / length(v); }

Vec3d corner(const mesh::Bounds& bounds, int i) {
  return {(i & 1) != 0 ? bounds.high.x : bounds.low.x, (i & 2) != 0 ? bounds.high.y : bounds.low.y,
          (i & 4) != 0 ? bounds.high.z : bounds.low.z};
}

/// A rigid motion into a viewer's axes, with `eye` at the origin.
Mat4d view_matrix(const Basis& basis, const Vec3d& eye) {
  Mat4d view;
  const Vec3d rows[] = {basis.right, basis.up, basis.back};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) view.at(row, column) = rows[row][column];
    view.at(row, 3) = -dot(rows[row], eye);
  }
  view.at(3, 3) = 1;
  return view;
}

}  // namespace

double half_height(const Camera& camera) { return std::tan(0.5 * camera.fov_degrees * kDegree); }

Basis basis_looking(const Vec3d& back) {
  const Vec3d axis = normalized(back);
  const bool steep = std::abs(axis.y) > 0.9999;
  const Vec3d up = steep ? Vec3d{0, 0, axis.y > 0 ? -1.0 : 1.0} : Vec3d{0, 1, 0};
  const Vec3d right = normalized(cross(up, axis));
  return {right, cross(axis, right), axis};
}

Basis basis_of(const Camera& camera) {
  const Vec3d back = camera.eye - camera.target;
  return basis_looking(length(back) > 0 ? back : Vec3d{0, 0, 1});
}

// A corner at (x, y, z) of the viewer's axes lies in the frame, seen along -z from the point (cx, cy, d), if
// |x - cx| <= (d - z) t with t = tan(fov_x / 2): d t >= A - cx and d t >= B + cx, where A and B are the
// largest z t + x and z t - x. So cx = (A - B) / 2 lets the camera come nearest, to d = (A + B) / (2 t). The
// same holds for y.
Camera frame_camera(const mesh::Bounds& bounds, double aspect, double fov_degrees) {
  const Basis basis = basis_looking({std::sin(kAzimuth) * std::cos(kElevation), std::sin(kElevation),
                                     std::cos(kAzimuth) * std::cos(kElevation)});
  const Vec3d middle = 0.5 * (bounds.low.to<double>() + bounds.high.to<double>());
  const double tan_y = std::tan(0.5 * fov_degrees * kDegree) / kMargin;
  Vec3d target = middle;
  double nearest = 0;  // the box's own reach towards the eye, which must stay outside
  for (int i = 0; i < 8; ++i) nearest = std::max(nearest, dot(corner(bounds, i) - middle, basis.back));
  double distance = 1.1 * nearest + 1e-3;
  for (const auto& [axis, tan] : {std::pair{basis.right, tan_y * aspect}, std::pair{basis.up, tan_y}}) {
    double a = 0, b = 0;  // the middle's own
    for (int i = 0; i < 8; ++i) {
      const Vec3d p = corner(bounds, i) - middle;
      a = std::max(a, dot(p, basis.back) * tan + dot(p, axis));
      b = std::max(b, dot(p, basis.back) * tan - dot(p, axis));
    }
    target += 0.5 * (a - b) * axis;
    distance = std::max(distance, 0.5 * (a + b) / tan);
  }
  return {target + distance * basis.back, target, fov_degrees};
}

Mat4d view_projection(const Camera& camera, double aspect, double near, double far) {
  const double scale = 1 / half_height(camera);
  Mat4d projection;
  projection.at(0, 0) = scale / aspect;
  projection.at(1, 1) = scale;
  projection.at(2, 2) = far / (near - far);
  projection.at(2, 3) = near * far / (near - far);
  projection.at(3, 2) = -1;
  return projection * view_matrix(basis_of(camera), camera.eye);
}

LightView light_view(const mesh::Bounds& bounds, const Vec3d& to_light, std::uint32_t texels) {
  const Basis basis = basis_looking(to_light);
  const Vec3d axes[] = {basis.right, basis.up, basis.back};
  LightView view;
  Mat4d& projection = view.projection;
  projection.at(3, 3) = 1;
  for (int axis = 0; axis < 3; ++axis) {
    double low = dot(axes[axis], corner(bounds, 0)), high = low;
    for (int i = 1; i < 8; ++i) {
      const double at = dot(axes[axis], corner(bounds, i));
      low = std::min(low, at);
      high = std::max(high, at);
    }
    const double span = std::max(1.02 * (high - low), 1e-3);
    view.span[axis] = span;
    const double middle = 0.5 * (low + high);
    const double scale = axis < 2 ? 2 / span : -1 / span;  // depth grows away from the light, from 0 to 1
    for (int column = 0; column < 3; ++column) projection.at(axis, column) = scale * axes[axis][column];
    projection.at(axis, 3) = -scale * middle + (axis < 2 ? 0 : 0.5);
    if (axis < 2) view.texel = std::max(view.texel, span / texels);
  }
  return view;
}

Vec3d default_light(const Camera& camera) {
  const Basis basis = basis_of(camera);
  const Vec3d flat_back = normalized(Vec3d{basis.back.x, 0, basis.back.z} + 1e-9 * basis.up);
  return normalized(-0.85 * basis.right + 0.90 * Vec3d{0, 1, 0} + 0.40 * flat_back);
}

}  // namespace weft::render
