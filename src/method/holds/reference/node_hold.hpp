// How an obstacle holds a node while a method moves it, in double. Source: docs/solvers/vbd.md and
// docs/solvers/xpbd.md, Obstacles.
#pragma once

#include <optional>
#include <vector>

#include "contact/reference/proximity/press.hpp"
#include "method/reference_ways.hpp"
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
  /// By its velocity at the start [m/s]. None where nothing presses the node.
  static std::optional<NodeHold> of(const Press& press, const Vec3d& velocity, const Substep& substep);

  /// The way at which its own part is least of those that obstacles allow, with Coulomb's friction: equation (7).
  Vec3d descend(const NodeDescent& node);
  /// The way, moved to where the obstacle allows it, as far as it has not been so yet: equations (19) and (20) of
  /// docs/solvers/xpbd.md.
  Vec3d project(const Vec3d& way);
  /// The node's velocity after that way: without what restores a gap, and with what a blow gives back [m/s].
  Vec3d velocity(const Vec3d& way, double dt) const;
  /// In the last descent or projection obstacles pressed the node.
  bool bears() const { return bears_; }
  /// All that presses it has about one direction: its pairs are the hold's.
  bool alike() const { return alike_; }

 private:
  Vec3d normal_, surface_way_;  // the way of the obstacle's surface [m]
  Vec3d held_;                  // how far projections have moved it [m]
  double least_ = 0;            // how far along the normal the node has to go [m]
  double restored_ = 0;         // the part of it that restores a gap [m]
  double friction_ = 0;
  double return_speed_ = 0;  // at which a node that bears leaves the surface at least [m/s]
  bool alike_ = false, bears_ = false;
};

/// The holds of all nodes, in a method that answers obstacles by them.
class NodeHolds {
 public:
  /// Of the nodes that obstacles press in the substep.
  void take(const Substep& substep);
  /// The same, and where that takes them, ways begin there: `look_back` begins the substep with them, and sets `aim`.
  Ways begin(const Substep& substep, LookBack& look_back, std::vector<Vec3d>& aim);
  /// None: nothing presses the node.
  std::optional<NodeHold>& operator[](std::size_t node) { return holds_[node]; }
  bool bears(std::size_t node) const { return holds_[node] && holds_[node]->bears(); }
  /// As Stepper::held.
  std::vector<bool> held() const;
  /// The velocities of nodes with holds, whose ways have come to their end.
  void end(const Substep& substep, const std::vector<Vec3d>& ways) const;

 private:
  std::vector<std::optional<NodeHold>> holds_;
  bool answers_ = false;  // contact with obstacles, in the last substep
};

}  // namespace weft::reference
