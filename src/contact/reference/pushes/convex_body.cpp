#include "contact/reference/pushes/convex_body.hpp"

#include <algorithm>
#include <cmath>

#include "contact/reference/proximity/closest.hpp"

namespace weft::reference {
namespace {

std::array<Vec3d, 3> corners_of(const TrianglePoints& t) { return {t.a, t.b, t.c}; }

/// Of the body and the triangle along a unit axis.
double gap_along(const Vec3d& axis, const std::array<Vec3d, 3>& corners, const ConvexBody& body) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const Vec3d& corner : corners) least = std::min(least, dot(axis, corner - corners[0]));
  for (const Vec3d& point : body.points) most = std::max(most, dot(axis, point - corners[0]));
  return least - most;
}

/// The nearest points of a triangle and a body that are apart.
class NearestFeatures {
 public:
  NearestFeatures(const std::array<Vec3d, 3>& corners, const ConvexBody& body)
      : corners_(corners), body_(body) {}

  ConvexContact run() {
    const auto& [a, b, c] = corners_;
    for (const mesh::Triangle& face : body_.faces)
      for (std::size_t k = 0; k < 3; ++k) {
        const ClosestOnTriangle on = closest_on_triangle(corners_[k], body_.points[face[0]],
                                                         body_.points[face[1]], body_.points[face[2]]);
        std::array<double, 3> weights{};
        weights[k] = 1;
        take(weights, corners_[k] - on.offset, on.distance);
      }
    for (const Vec3d& point : body_.points) {
      const ClosestOnTriangle on = closest_on_triangle(point, a, b, c);
      take(on.weights, point, on.distance);
    }
    for (const mesh::Edge& edge : body_.edges)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const ClosestSegments on =
            closest_segments(corners_[k], corners_[next], body_.points[edge[0]], body_.points[edge[1]]);
        std::array<double, 3> weights{};
        weights[k] = 1 - on.s;
        weights[next] = on.s;
        take(weights, body_.points[edge[0]] + on.t * (body_.points[edge[1]] - body_.points[edge[0]]),
             on.distance);
      }
    const Vec3d at = best_.weights[0] * a + best_.weights[1] * b + best_.weights[2] * c;
    best_.normal = best_.distance > 0 ? (at - best_.point) / length(at - best_.point) : Vec3d{};
    return best_;
  }

 private:
  void take(const std::array<double, 3>& weights, const Vec3d& point, double distance) {
    if (distance < best_.distance) best_ = {weights, point, {}, distance};
  }

  const std::array<Vec3d, 3>& corners_;
  const ConvexBody& body_;
  ConvexContact best_{{}, {}, {}, HUGE_VAL};
};

}  // namespace

ConvexBody::ConvexBody(const mesh::TriangleMesh& hull)
    : faces(hull.triangles), edges(mesh::mesh_edges(hull.triangles)) {
  for (const Vec3f& p : hull.positions) points.push_back(p.to<double>());
  low = high = points[0];
  for (const Vec3d& p : points) {
    low = min(low, p);
    high = max(high, p);
  }
  for (const mesh::Triangle& face : faces) {
    const Vec3d area = cross(points[face[1]] - points[face[0]], points[face[2]] - points[face[0]]);
    normals.push_back(area / length(area));
  }
  std::vector<std::array<std::uint32_t, 2>> ways;
  for (const auto& [a, b] : edges) {
    ways.push_back({a, b});
    ways.push_back({b, a});
  }
  std::sort(ways.begin(), ways.end());
  beside.offsets.assign(points.size() + 1, 0);
  for (const auto& [from, to] : ways) {
    ++beside.offsets[from + 1];
    beside.entries.push_back(to);
  }
  for (std::size_t p = 0; p < points.size(); ++p) beside.offsets[p + 1] += beside.offsets[p];
}

double pair_size(const TrianglePoints& triangle, const ConvexBody& body) {
  const Vec3d low = min(min(triangle.a, triangle.b), triangle.c),
              high = max(max(triangle.a, triangle.b), triangle.c);
  const Vec3d a = low - body.high, b = high - body.low;
  double size = 0;
  for (int axis = 0; axis < 3; ++axis) size = std::max({size, std::abs(a[axis]), std::abs(b[axis])});
  return size;
}

Separation separation(const TrianglePoints& triangle, const ConvexBody& body, bool to_know_sign) {
  const std::array<Vec3d, 3> corners = corners_of(triangle);
  Separation best{{0, 1, 0}, -HUGE_VAL};
  const auto take = [&](const Vec3d& axis, double gap) {
    if (gap > best.distance) best = {axis, gap};
  };
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    double least = HUGE_VAL;
    for (const Vec3d& corner : corners)
      least = std::min(least, dot(body.normals[f], corner - body.points[body.faces[f][0]]));
    take(body.normals[f], least);
  }
  const auto take_both = [&](const Vec3d& direction) {
    const double size = length(direction);
    if (!(size > 0)) return;
    for (const Vec3d& axis : {direction / size, -direction / size})
      take(axis, gap_along(axis, corners, body));
  };
  take_both(cross(corners[1] - corners[0], corners[2] - corners[0]));
  for (const mesh::Edge& edge : body.edges) {
    if (to_know_sign && best.distance > 0) return best;
    for (std::size_t k = 0; k < 3; ++k)
      take_both(cross(corners[(k + 1) % 3] - corners[k], body.points[edge[1]] - body.points[edge[0]]));
  }
  return best;
}

ConvexContact contact_by_features(const TrianglePoints& triangle, const ConvexBody& body) {
  const std::array<Vec3d, 3> corners = corners_of(triangle);
  const Separation apart = separation(triangle, body, true);
  if (apart.distance > 0) {
    ConvexContact contact = NearestFeatures(corners, body).run();
    if (contact.distance == 0) contact.normal = apart.axis;
    return contact;
  }
  const Vec3d out = (0.25 * pair_size(triangle, body) - apart.distance) * apart.axis;
  std::array<Vec3d, 3> moved = corners;
  for (Vec3d& corner : moved) corner += out;
  ConvexContact contact = NearestFeatures(moved, body).run();
  contact.normal = apart.axis;
  contact.distance = apart.distance;
  return contact;
}

}  // namespace weft::reference
