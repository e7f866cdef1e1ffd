#include "mesh/closed_surface.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "base/words.hpp"
#include "mesh/closest.hpp"
#include "mesh/sides.hpp"

namespace weft::mesh {
namespace {

constexpr std::uint32_t kLeafSize = 4;  // triangles
constexpr std::size_t kMaxDepth = 64;   // halving 2^32 triangles takes 32 levels

double square_to_box(const Vec3d& point, const Vec3f& low, const Vec3f& high) {
  double square = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double below = static_cast<double>(low[axis]) - point[axis];
    const double above = point[axis] - static_cast<double>(high[axis]);
    const double away = std::max({below, above, 0.0});
    square += away * away;
  }
  return square;
}

/// A line along an axis, seen along it as a point of u and v.
struct AxisLine {
  AxisLine(int along, const Vec3d& through)
      : axis(along),
        u_axis((along + 1) % 3),
        v_axis((along + 2) % 3),
        u(through[u_axis]),
        v(through[v_axis]) {}

  // Whether an edge lies to the right of the line: from (u, v) towards larger u one comes across it. The caller gives
  // its ends in one order for both triangles, so that rounding does not tell them apart.
  bool has_right(const Vec3d& a, const Vec3d& b) const {
    if ((a[v_axis] > v) == (b[v_axis] > v)) return false;
    const double at = a[u_axis] + (v - a[v_axis]) * (b[u_axis] - a[u_axis]) / (b[v_axis] - a[v_axis]);
    return std::clamp(at, std::min(a[u_axis], b[u_axis]), std::max(a[u_axis], b[u_axis])) > u;
  }

  int axis, u_axis, v_axis;
  double u, v;
};

// Where the line goes through a triangle, on its axis.
std::optional<double> crossing(const AxisLine& line, const std::vector<Vec3f>& positions, Triangle triangle) {
  bool inside = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
    if (line.has_right(positions[std::min(a, b)].to<double>(), positions[std::max(a, b)].to<double>()))
      inside = !inside;
  }
  if (!inside) return std::nullopt;
  std::sort(triangle.begin(), triangle.end());
  const Vec3d a = positions[triangle[0]].to<double>(), b = positions[triangle[1]].to<double>(),
              c = positions[triangle[2]].to<double>();
  const Vec3d normal = cross(b - a, c - a);
  const double low = std::min({a[line.axis], b[line.axis], c[line.axis]});
  const double high = std::max({a[line.axis], b[line.axis], c[line.axis]});
  const double slope = normal[line.axis];
  if (slope == 0) return (low + high) / 2;  // on edge
  const double fall =
      normal[line.u_axis] * (line.u - a[line.u_axis]) + normal[line.v_axis] * (line.v - a[line.v_axis]);
  return std::clamp(a[line.axis] - fall / slope, low, high);
}

bool is_under(const std::vector<double>& sorted, double at) {
  return (sorted.end() - std::upper_bound(sorted.begin(), sorted.end(), at)) % 2 != 0;
}

}  // namespace

Result<ClosedSurface> ClosedSurface::create(const TriangleMesh& mesh) {
  WEFT_CHECK(check_mesh(mesh));
  ClosedSurface surface;
  surface.positions_ = mesh.positions;
  for (const Triangle& t : mesh.triangles)
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) surface.triangles_.push_back(t);
  if (surface.triangles_.empty()) return input_error("Every triangle of the surface names a vertex twice.");

  const std::vector<Side> sides = sorted_sides(surface.triangles_);
  std::span<const Side> open;
  for_each_edge(std::span(sides), [&](std::span<const Side> edge) {
    if (edge.size() != 2 && open.empty()) open = edge;
  });
  if (!open.empty())
    return input_error("The surface is not closed: the edge between vertices %u and %u has %s, not 2.",
                       open[0].nodes[0], open[0].nodes[1],
                       counted(open.size(), "triangle", "triangles").c_str());

  const auto count = static_cast<std::uint32_t>(surface.triangles_.size());
  surface.nodes_.reserve(count);
  surface.nodes_.emplace_back();
  surface.build(0, 0, count);
  surface.bounds_ = {surface.nodes_[0].low, surface.nodes_[0].high};
  return surface;
}

// Halves of the triangles by their places along the box's longest side. Ties go by the triangles' own order, so that
// every library makes the same tree.
void ClosedSurface::build(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
  Vec3f low = positions_[triangles_[begin][0]], high = low;
  for (std::uint32_t t = begin; t < end; ++t)
    for (const std::uint32_t vertex : triangles_[t]) {
      low = min(low, positions_[vertex]);
      high = max(high, positions_[vertex]);
    }
  nodes_[node].low = low;
  nodes_[node].high = high;
  if (end - begin <= kLeafSize) {
    nodes_[node].first = begin;
    nodes_[node].count = end - begin;
    return;
  }
  const Vec3d size = high.to<double>() - low.to<double>();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto place = [&](const Triangle& t) {
    double sum = 0;
    for (const std::uint32_t vertex : t) sum += static_cast<double>(positions_[vertex][axis]);
    return sum;
  };
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(triangles_.begin() + begin, triangles_.begin() + middle, triangles_.begin() + end,
                   [&](const Triangle& a, const Triangle& b) {
                     const double at_a = place(a), at_b = place(b);
                     return at_a != at_b ? at_a < at_b : a < b;
                   });
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].first = child;
  nodes_.emplace_back();
  nodes_.emplace_back();
  build(child, begin, middle);
  build(child + 1, middle, end);
}

double ClosedSurface::distance(const Vec3d& point) const {
  struct Entry {
    double square;
    std::uint32_t node;
  };
  std::array<Entry, kMaxDepth> stack;
  std::size_t size = 0;
  stack[size++] = {0, 0};
  double best = std::numeric_limits<double>::infinity(), best_square = best;
  while (size > 0) {
    const Entry entry = stack[--size];
    if (entry.square >= best_square) continue;
    const Node& node = nodes_[entry.node];
    if (node.count == 0) {
      Entry near{square_to_box(point, nodes_[node.first].low, nodes_[node.first].high), node.first};
      Entry far{square_to_box(point, nodes_[node.first + 1].low, nodes_[node.first + 1].high),
                node.first + 1};
      if (far.square < near.square) std::swap(near, far);
      stack[size++] = far;
      stack[size++] = near;
      continue;
    }
    for (std::uint32_t t = node.first; t < node.first + node.count; ++t) {
      const Triangle& corners = triangles_[t];
      const double found =
          closest_on_triangle(point, positions_[corners[0]].to<double>(), positions_[corners[1]].to<double>(),
                              positions_[corners[2]].to<double>())
              .distance;
      if (found < best) best = found, best_square = found * found;
    }
  }
  return best;
}

void ClosedSurface::crossings(int axis, const Vec3d& point, std::vector<double>& found) const {
  found.clear();
  const AxisLine line(axis, point);
  std::array<std::uint32_t, kMaxDepth> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const Node& node = nodes_[stack[--size]];
    const auto misses = [&](int side, double at) {
      return at < static_cast<double>(node.low[side]) || at > static_cast<double>(node.high[side]);
    };
    if (misses(line.u_axis, line.u) || misses(line.v_axis, line.v)) continue;
    if (node.count == 0) {
      stack[size++] = node.first;
      stack[size++] = node.first + 1;
      continue;
    }
    for (std::uint32_t t = node.first; t < node.first + node.count; ++t)
      if (const auto at = crossing(line, positions_, triangles_[t])) found.push_back(*at);
  }
  std::sort(found.begin(), found.end());
}

double ClosedSurface::depth(const Vec3d& point) const {
  int votes = 0;
  std::vector<double> found;
  for (int axis = 0; axis < 3; ++axis) {
    crossings(axis, point, found);
    if (is_under(found, point[axis])) ++votes;
  }
  const double away = distance(point);
  return votes >= 2 ? away : -away;
}

}  // namespace weft::mesh
