// Random triangles for tests of trees and pairs.
#pragma once

#include <vector>

#include "base/random.hpp"
#include "contact/reference/proximity/audit.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft {

inline Vec3d random_point(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

/// Triangles of any place and shape, positions as f32 has them.
struct Soup {
  std::vector<Vec3d> positions;
  std::vector<mesh::Triangle> triangles;

  operator reference::Surfaces() const { return {positions, triangles}; }
  mesh::TriangleMesh mesh() const {
    mesh::TriangleMesh made;
    for (const Vec3d& p : positions) made.positions.push_back(p.to<float>());
    made.triangles = triangles;
    return made;
  }
};

/// In a box of 1.2 m, each up to 2 `reach` [m] long. Every third shares two vertices with its forerunner.
inline Soup random_soup(Random& random, std::uint32_t count, double reach) {
  Soup soup;
  for (std::uint32_t t = 0; t < count; ++t) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    const bool neighbour = t % 3 == 2;
    const Vec3d place = neighbour ? soup.positions[first - 1] : random_point(random, 0.6);
    for (int corner = 0; corner < (neighbour ? 1 : 3); ++corner)
      soup.positions.push_back((place + random_point(random, reach)).to<float>().to<double>());
    if (neighbour) {
      soup.triangles.push_back({first - 1, first - 2, first});
    } else {
      soup.triangles.push_back({first, first + 1, first + 2});
    }
  }
  return soup;
}

}  // namespace weft
