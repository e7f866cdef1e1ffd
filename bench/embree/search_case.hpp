// A query of the broad phase, and what answers it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "model/host_model.hpp"

namespace weft {

/// Which triangles of a sheet are near each other, or near an object: those whose boxes overlap where one of
/// them is grown by the radius, but for neighbours that lie flat (docs/contact.md).
struct SearchCase {
  std::string pose;
  HostModel model;
  std::vector<Vec3f> positions;  // of the sheet's nodes [m]
  mesh::TriangleMesh object;     // without triangles: the sheet meets itself
  float thickness = 0;           // [m]
  float reach = 0;               // [m]; twice that on top of the thickness is the radius

  bool self() const { return object.triangles.empty(); }
  float radius() const { return thickness + 2 * reach; }
};

/// A pair of triangles as one number: the sheet's by its place in weft's order, in the upper half; then the
/// other, likewise or by its number in the object. Of two of the sheet the earlier comes first.
using PairKey = std::uint64_t;
inline PairKey pair_key(std::uint32_t own, std::uint32_t other) { return PairKey{own} << 32U | other; }

}  // namespace weft
