// What threads do next, and which nodes become one. Source: docs/sewing.md.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "model/sewn.hpp"

namespace weft {

/// How long threads pull with one stiffness [s].
inline constexpr double kThreadTime = 1.0 / 15;

/// A seam that has just been closed, or that is waited for no longer.
struct SeamNews {
  std::string where;     // file and JSON path
  std::size_t open = 0;  // pairs that are no one node
  double widest = 0;     // of these [m]
};

struct Sewn {
  Sewing sewing;  // from now on
  std::vector<SeamNews> news;
};

/// Gives the pairs that are not one node yet threads that pull with a force between half and all of the seam's, softer
/// where that would be wider than `within` at rest; and makes one of the pairs of seams all of whose are near enough,
/// of seams that are waited for no longer those that are. Done every kThreadTime.
/// Reads   model: sewn_model of `before`; position: of its nodes [m]; time, and how long ago this was done last [s].
Sewn sew(const Model& model, const Sewing& before, std::span<const Vec3d> position, double time,
         double since);

}  // namespace weft
