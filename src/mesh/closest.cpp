#include "mesh/closest.hpp"

#include <algorithm>

namespace weft::mesh {

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

}  // namespace weft::mesh
