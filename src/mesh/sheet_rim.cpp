#include "mesh/sheet_rim.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace weft {
namespace {

/// A number for each vertex that all vertices of its connected part share.
std::vector<std::uint32_t> connected_parts(std::size_t vertex_count,
                                           std::span<const mesh::Triangle> triangles) {
  std::vector<std::uint32_t> part(vertex_count);
  std::iota(part.begin(), part.end(), 0U);
  const auto root = [&](std::uint32_t v) {
    while (part[v] != v) v = part[v] = part[part[v]];
    return v;
  };
  for (const mesh::Triangle& t : triangles)
    for (std::size_t k = 1; k < 3; ++k) {
      const std::uint32_t a = root(t[0]), b = root(t[k]);
      part[std::max(a, b)] = std::min(a, b);
    }
  for (std::uint32_t v = 0; v < vertex_count; ++v) part[v] = root(v);
  return part;
}

struct SideOfTriangle {
  std::array<std::uint32_t, 2> vertices{};  // the lower first
  std::uint32_t triangle = 0, side = 0;     // from corner `side` to the next
  bool rises = false;                       // passed from the lower to the higher
  bool operator<(const SideOfTriangle& other) const {
    return vertices != other.vertices ? vertices < other.vertices : triangle < other.triangle;
  }
};

/// By the lower vertex first, in one pass, as there may be millions.
std::vector<SideOfTriangle> sorted_sides(std::span<const mesh::Triangle> triangles) {
  const auto lower = [&](std::uint32_t t, std::uint32_t k) {
    return std::min(triangles[t][k], triangles[t][(k + 1) % 3]);
  };
  std::vector<std::size_t> next(1, 0);
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::size_t vertex = lower(t, k);
      if (vertex + 2 > next.size()) next.resize(vertex + 2, 0);
      ++next[vertex + 1];
    }
  std::partial_sum(next.begin(), next.end(), next.begin());
  const std::vector<std::size_t> offsets = next;
  std::vector<SideOfTriangle> sides(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      sides[next[lower(t, k)]++] = {{std::min(a, b), std::max(a, b)}, t, k, a < b};
    }
  for (std::size_t v = 0; v + 1 < offsets.size(); ++v)
    std::sort(sides.begin() + std::ptrdiff_t(offsets[v]), sides.begin() + std::ptrdiff_t(offsets[v + 1]));
  return sides;
}

}  // namespace

std::vector<double> rim_distances(std::span<const Vec3d> positions,
                                  std::span<const mesh::Triangle> triangles) {
  struct Part {
    double count = 0, radius = 0;
    Vec3d middle;
    std::uint32_t seen = 0;
  };
  const std::vector<std::uint32_t> part_of = connected_parts(positions.size(), triangles);
  std::vector<Part> parts(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    Part& part = parts[part_of[v]];
    part.middle += positions[v];
    ++part.count;
  }
  for (Part& part : parts)
    if (part.count > 0) part.middle = part.middle / part.count;
  std::vector<Vec3d> third(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v)
    if (Part& part = parts[part_of[v]]; part.seen++ == static_cast<std::uint32_t>(part.count) / 3)
      third[part_of[v]] = positions[v];
  for (std::size_t p = 0; p < parts.size(); ++p)
    if (parts[p].count > 0) parts[p].middle += 0.1 * (third[p] - parts[p].middle);
  std::vector<double> distance(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    Part& part = parts[part_of[v]];
    distance[v] = length(positions[v] - part.middle);
    part.radius = std::max(part.radius, distance[v]);
  }
  for (std::size_t v = 0; v < positions.size(); ++v) distance[v] = parts[part_of[v]].radius - distance[v];
  return distance;
}

bool faces_outward(std::span<const Vec3d> positions, std::span<const mesh::Triangle> triangles) {
  const std::vector<SideOfTriangle> sides = sorted_sides(triangles);
  if (sides.empty() || sides.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    const bool pair = sides[i].vertices == sides[i + 1].vertices && sides[i].rises != sides[i + 1].rises;
    const bool more = i + 2 < sides.size() && sides[i + 2].vertices == sides[i].vertices;
    if (!pair || more) return false;
  }
  double volume = 0;  // six times, from the first vertex
  for (const mesh::Triangle& t : triangles)
    volume += dot(positions[t[0]] - positions[0],
                  cross(positions[t[1]] - positions[0], positions[t[2]] - positions[0]));
  return volume > 0;
}

std::vector<mesh::Triangle> opposite_corners(std::span<const mesh::Triangle> triangles) {
  const std::vector<SideOfTriangle> sides = sorted_sides(triangles);
  std::vector<mesh::Triangle> corners(triangles.size(), {kNoCorner, kNoCorner, kNoCorner});
  const auto tip = [&](const SideOfTriangle& side) { return triangles[side.triangle][(side.side + 2) % 3]; };
  for (std::size_t first = 0, i = 0; i < sides.size(); ++i) {
    if (sides[i].vertices != sides[first].vertices) first = i;
    if (i == first) continue;  // all others see the first, and the first the second
    corners[sides[i].triangle][sides[i].side] = tip(sides[first]);
    if (i == first + 1) corners[sides[first].triangle][sides[first].side] = tip(sides[i]);
  }
  return corners;
}

}  // namespace weft
