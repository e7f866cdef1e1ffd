// How an obstacle holds a node while it descends, in double. Source: docs/solvers/vbd.md, Obstacles.
#pragma once

#include <optional>

#include "contact/reference/proximity/press.hpp"
#include "method/sym3.hpp"

namespace weft::reference {

/// A node's own part of what the substep minimises, about where the node is: least at `free`.
struct NodeDescent {
  Vec3d free;    // way [m]
  Sym3 hessian;  // by the node's inertia
};

/// What obstacles ask of a node in a substep: they press it, and their friction holds it.
class NodeHold {
 public:
  /// `ahead` is where its velocity at the start leads [m]. None where nothing presses the node.
  static std::optional<NodeHold> of(const Press& press, const Vec3d& ahead, double dt);

  /// The way at which its own part is least of those that obstacles allow, with Coulomb's friction: equation (7).
  Vec3d descend(const NodeDescent& node);
  /// The way without what restores a gap, which the node's velocity does not have [m].
  Vec3d moved(const Vec3d& way) const { return bears_ ? way - restored_ * normal_ : way; }
  /// In the last descent obstacles pressed the node.
  bool bears() const { return bears_; }
  /// All that presses it has about one direction: its pairs are the hold's.
  bool alike() const { return alike_; }

 private:
  Vec3d normal_, surface_way_;  // the way of the obstacle's surface [m]
  double least_ = 0;            // how far along the normal the node has to go [m]
  double restored_ = 0;         // the part of it that restores a gap [m]
  double friction_ = 0;
  bool alike_ = false, bears_ = false;
};

}  // namespace weft::reference
