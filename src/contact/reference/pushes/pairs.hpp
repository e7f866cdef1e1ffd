// All intersecting pairs of two meshes, by brute force in double.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/reference/pushes/segment_triangle.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::reference {

struct TrianglePair {
  std::uint32_t cloth = 0, object = 0;
  auto operator<=>(const TrianglePair&) const = default;
};

struct PairList {
  std::vector<TrianglePair> hits;       // sorted
  std::vector<TrianglePair> ambiguous;  // sorted
  std::uint64_t candidates = 0;         // pairs whose boxes overlap
};

TrianglePoints points_of(const mesh::TriangleMesh& mesh, std::uint32_t triangle);

/// Every cloth triangle against every object triangle. Pairs whose boxes are apart by more than the f32
/// kernels' bound, 2^-21 of the largest cloth coordinate, miss there and have no common point here, so
/// skipping them loses nothing; twice that bound is taken, so that no rounding of it matters. Cloth triangles
/// that are not finite have no pairs.
PairList find_pairs(const mesh::TriangleMesh& cloth, const mesh::TriangleMesh& object);

}  // namespace weft::reference
