#include "contact/reference/proximity/closest.hpp"

namespace weft::reference {

ClosestSegments closest_segments(const Vec3d& a0, const Vec3d& a1, const Vec3d& b0, const Vec3d& b1) {
  // The four ends first: among them is the closest pair unless both points are inside.
  const ClosestOnSegment from_a0 = closest_on_segment(a0, b0, b1);
  ClosestSegments best{0, from_a0.t, from_a0.offset, from_a0.distance};
  const auto take = [&](double s, double t, const Vec3d& offset, double distance) {
    if (distance < best.distance) best = {s, t, offset, distance};
  };
  const ClosestOnSegment from_a1 = closest_on_segment(a1, b0, b1);
  take(1, from_a1.t, from_a1.offset, from_a1.distance);
  const ClosestOnSegment from_b0 = closest_on_segment(b0, a0, a1), from_b1 = closest_on_segment(b1, a0, a1);
  take(from_b0.t, 0, -from_b0.offset, from_b0.distance);
  take(from_b1.t, 1, -from_b1.offset, from_b1.distance);
  // b0 - a0 = s d_a - t d_b + k n, solved as for the triangle.
  const Vec3d along_a = a1 - a0, along_b = b1 - b0, between = b0 - a0, n = cross(along_a, along_b);
  const double square = dot(n, n);
  if (!(square > 0)) return best;
  const double s = dot(cross(between, along_b), n) / square, t = dot(cross(between, along_a), n) / square;
  if (!(s > 0 && s < 1 && t > 0 && t < 1)) return best;
  const Vec3d offset = s * along_a - t * along_b - between;
  take(s, t, offset, length(offset));
  return best;
}

Vec3d offset_between(std::uint32_t count_a, std::uint32_t count_b, const std::array<Vec3d, 4>& at) {
  if (count_b == 1) return at[0] - at[1];
  if (count_a == 2) return closest_segments(at[0], at[1], at[2], at[3]).offset;
  return closest_on_triangle(at[0], at[1], at[2], at[3]).offset;
}

Gap gap_of(const Vec3d& offset, double radius) {
  const double distance = length(offset);
  return {distance > 0 ? offset / distance : Vec3d{0, 1, 0}, distance - radius};
}

Gap plane_gap(const Vec3d& point, const Vec3d& on_plane, const Vec3d& normal) {
  return {normal, dot(normal, point - on_plane)};
}

}  // namespace weft::reference
