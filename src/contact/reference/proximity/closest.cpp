#include "contact/reference/proximity/closest.hpp"

#include <algorithm>

namespace weft::reference {

ClosestOnSegment closest_on_segment(const Vec3d& p, const Vec3d& a, const Vec3d& b) {
  const Vec3d along = b - a, from_a = p - a;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(from_a, along) / square, 0.0, 1.0) : 0.0;
  const Vec3d offset = t < 1 ? from_a - t * along : p - b;
  return {t, offset, length(offset)};
}

ClosestOnTriangle closest_on_triangle(const Vec3d& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d* corners[] = {&a, &b, &c};
  ClosestOnTriangle best;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const ClosestOnSegment edge = closest_on_segment(p, *corners[k], *corners[next]);
    if (k > 0 && !(edge.distance < best.distance)) continue;
    best = {{}, edge.offset, edge.distance};
    best.weights[k] = 1 - edge.t;
    best.weights[next] = edge.t;
  }
  // p - a = v ab + w ac + k n. Crossed with ac or ab and taken along n, all terms but one are zero.
  const Vec3d ab = b - a, ac = c - a, ap = p - a, n = cross(ab, ac);
  const double square = dot(n, n);
  if (!(square > 0)) return best;
  const double v = dot(cross(ap, ac), n) / square, w = dot(cross(ab, ap), n) / square;
  if (!(v > 0 && w > 0 && v + w < 1)) return best;
  const Vec3d offset = ap - v * ab - w * ac;
  const double distance = length(offset);
  if (distance < best.distance) best = {{1 - v - w, v, w}, offset, distance};
  return best;
}

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

Gap gap_of(const Vec3d& offset, double radius) {
  const double distance = length(offset);
  return {distance > 0 ? offset / distance : Vec3d{0, 1, 0}, distance - radius};
}

Gap plane_gap(const Vec3d& point, const Vec3d& on_plane, const Vec3d& normal) {
  return {normal, dot(normal, point - on_plane)};
}

}  // namespace weft::reference
