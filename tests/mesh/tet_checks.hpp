// What holds of every tetrahedral mesh, counted by the tests' own code.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "mesh/tet_mesh.hpp"

namespace weft {

/// Faces by their sorted vertices; of each how many tetrahedra have it.
inline std::map<mesh::Triangle, int> face_counts(const std::vector<mesh::Tet>& tets) {
  std::map<mesh::Triangle, int> counts;
  for (mesh::Tet tet : tets) {
    std::sort(tet.begin(), tet.end());
    for (std::size_t without = 0; without < 4; ++without) {
      mesh::Triangle face{};
      for (std::size_t k = 0, filled = 0; k < 4; ++k)
        if (k != without) face[filled++] = tet[k];
      ++counts[face];
    }
  }
  return counts;
}

/// Where triangles are no closed surface: edges that are not once in each direction, vertices without a single fan.
struct SurfaceFaults {
  std::size_t edges = 0, vertices = 0;
};
inline SurfaceFaults surface_faults(const std::vector<mesh::Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
  std::map<std::uint32_t, std::vector<std::pair<std::uint32_t, std::uint32_t>>> links;
  for (const mesh::Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      ++directed[{t[k], t[(k + 1) % 3]}];
      links[t[k]].push_back({t[(k + 1) % 3], t[(k + 2) % 3]});
    }
  SurfaceFaults faults;
  for (const auto& [edge, count] : directed)
    if (count != 1 || directed.count({edge.second, edge.first}) == 0) ++faults.edges;
  for (const auto& [vertex, link] :
       links) {  // the edges opposite a vertex: one ring that passes through all of them
    std::map<std::uint32_t, std::uint32_t> next(link.begin(), link.end());
    std::uint32_t at = link.front().first;
    std::size_t steps = 0;
    do {
      const auto found = next.find(at);
      if (found == next.end()) break;
      at = found->second;
      ++steps;
    } while (at != link.front().first && steps <= link.size());
    if (steps != link.size() || next.size() != link.size()) ++faults.vertices;
  }
  return faults;
}

/// Vertices - edges + faces.
inline int euler_characteristic(const std::vector<mesh::Triangle>& triangles) {
  std::set<std::uint32_t> vertices;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const mesh::Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      vertices.insert(t[k]);
      edges.insert(std::minmax({t[k], t[(k + 1) % 3]}));
    }
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(triangles.size());
}

inline mesh::TriangleMesh boundary_mesh(const mesh::TetMesh& mesh) {
  return {mesh.positions, mesh::boundary(mesh.tets)};
}

/// m²
inline double area(const mesh::TriangleMesh& mesh) {
  double twice = 0;
  for (const mesh::Triangle& t : mesh.triangles) {
    const Vec3d a = mesh.positions[t[0]].to<double>();
    twice += length(cross(mesh.positions[t[1]].to<double>() - a, mesh.positions[t[2]].to<double>() - a));
  }
  return twice / 2;
}

/// The volumes of tetrahedra by Heron's formula in space, from the lengths of edges alone: it has no sign and no cross
/// product. Source: Sabitov 1996, or Cayley and Menger.
inline double volume_by_lengths(const std::array<Vec3d, 4>& p) {
  const auto square = [&](std::size_t a, std::size_t b) { return dot(p[a] - p[b], p[a] - p[b]); };
  const double ab = square(0, 1), ac = square(0, 2), ad = square(0, 3), bc = square(1, 2), bd = square(1, 3),
               cd = square(2, 3);
  const double x = ac + ad - cd, y = ab + ad - bd, z = ab + ac - bc;
  return std::sqrt(std::max(0.0, 4 * ab * ac * ad - ab * x * x - ac * y * y - ad * z * z + x * y * z)) / 12;
}

}  // namespace weft
