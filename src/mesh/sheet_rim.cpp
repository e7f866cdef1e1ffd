#include "mesh/sheet_rim.hpp"

#include <algorithm>
#include <numeric>

#include "mesh/sides.hpp"

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
  const std::vector<mesh::Side> sides = mesh::sorted_sides(triangles);
  const auto rises = [&](const mesh::Side& side) {
    return triangles[side.triangle][side.start()] == side.nodes[0];
  };
  if (sides.empty() || sides.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    const bool pair = sides[i].nodes == sides[i + 1].nodes && rises(sides[i]) != rises(sides[i + 1]);
    const bool more = i + 2 < sides.size() && sides[i + 2].nodes == sides[i].nodes;
    if (!pair || more) return false;
  }
  double volume = 0;  // six times, from the first vertex
  for (const mesh::Triangle& t : triangles)
    volume += dot(positions[t[0]] - positions[0],
                  cross(positions[t[1]] - positions[0], positions[t[2]] - positions[0]));
  return volume > 0;
}

std::vector<mesh::Triangle> opposite_corners(std::span<const mesh::Triangle> triangles) {
  std::vector<mesh::Triangle> corners(triangles.size(), {kNoCorner, kNoCorner, kNoCorner});
  const auto tip = [&](const mesh::Side& side) { return triangles[side.triangle][side.corner]; };
  mesh::for_each_edge(mesh::sorted_sides(triangles), [&](std::span<const mesh::Side> sides) {
    for (std::size_t i = 1; i < sides.size(); ++i)  // all others see the first, and the first the second
      corners[sides[i].triangle][sides[i].start()] = tip(sides[0]);
    if (sides.size() > 1) corners[sides[0].triangle][sides[0].start()] = tip(sides[1]);
  });
  return corners;
}

}  // namespace weft
