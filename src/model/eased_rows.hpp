// Rows of unequal numbers of nodes, which are to be sewn together: the one that has fewer gets more.
#pragma once

#include <cstdint>
#include <vector>

#include "model/model.hpp"

namespace weft {

/// A cloth taken out of a model, whose nodes count from 0.
struct LooseCloth {
  std::vector<Vec3d> rest, start;  // [m]
  std::vector<std::array<float, 2>> uv;
  std::vector<double> mass;           // [kg]
  std::vector<std::uint32_t> motion;  // as Model::motion
  std::vector<mesh::Triangle> triangles;
  std::vector<Vec3d> warps;  // as Body::warps

  LooseCloth(const Model& model, const Body& body);
  /// Makes it the body of this number, which may have grown.
  void put_back(Model& model, std::size_t number) const;
};

/// Puts nodes between those of the row that has fewer, where the other one's are by length, so that both have as many:
/// its own ones meet those that are nearest by length, each another one, ends meet ends. Triangles at the rim are
/// parted as fans, and share their masses. False: an edge of the row is at no rim any more, or is the row's only node.
bool ease(LooseCloth& cloth, std::vector<std::uint32_t>& first, std::vector<std::uint32_t>& second);

}  // namespace weft
