// A query of the broad phase, and what answers it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "model/model.hpp"

namespace weft {

/// Which triangles of a sheet are near each other, or near an object: those whose boxes overlap where the
/// sheet's are grown by how far its nodes may go and one of a pair by the thickness too, but for neighbours
/// that lie flat (docs/contact.md).
struct SearchCase {
  std::string pose;
  Model model;
  std::vector<Vec3f> positions;  // of the sheet's nodes [m]
  mesh::TriangleMesh object;     // without triangles: the sheet meets itself
  float thickness = 0;           // [m]
  float reach = 0;               // of a node at rest [m]
  float flat_reach = 0;          // up to which neighbours that lie flat are left out [m]

  bool self() const { return object.triangles.empty(); }
  float own_radius() const { return thickness + reach; }
  float other_radius() const { return self() ? reach : 0; }
};

/// A pair of triangles as one number: the sheet's by its place in weft's order, in the upper half; then the
/// other, in the same way or by its number in the object. Of two of the sheet the earlier comes first.
using PairKey = std::uint64_t;
inline PairKey pair_key(std::uint32_t own, std::uint32_t other) { return PairKey{own} << 32U | other; }

}  // namespace weft
