// What holds a node at obstacles within an implicit step, and the force that stays of it, in double. Source:
// docs/solvers/multigrid.md, Contact.
#pragma once

#include <optional>

#include "contact/reference/proximity/press.hpp"
#include "method/sym3.hpp"

namespace weft::reference {

/// How stiffly an obstacle holds a node along its normal and across it, in the node's inertia; of what stops a node
/// that lands, the least part that is kept.
inline constexpr double kHoldStiffness = 30, kSlipStiffness = 1, kMostFreed = 1, kLanded = 1e-5;

/// The force that obstacles hold a node with [N]: it stays from substep to substep.
struct HoldForce {
  double normal = 0;         // λ: what it bears, without what restores a gap
  Vec3d along;               // τ, of friction
  bool under_cloth = false;  // it was held, and its pairs keep the force instead
};

/// A node before its system is solved.
struct HoldInputs {
  double inertia = 0;          // a [N/m]
  std::optional<Sym3> behind;  // of a body's node: its block of the matrix, without the hold [N/m]
  double mass = 0;             // [kg]
  double dt = 0;               // [s]
  Vec3d load;                  // R [N]; in a second system 0: what stiff springs have left is none
  Vec3d start;                 // s₀ [m]
  Vec3d ahead;                 // Δt times the velocity at the substep's start [m]
};

/// Equation (11) for one node.
class Hold {
 public:
  /// None where nothing presses the node.
  static std::optional<Hold> of(const Press& press, const HoldForce& kept, const HoldInputs& node);

  Vec3d force() const;  // what the residual gets [N]
  Sym3 block() const;   // what the matrix gets [N/m]
  bool sticks() const { return sticks_; }
  /// All that presses the node has about one direction, and it has borne before: its pairs are the hold's.
  bool alike() const { return alike_; }

  struct End {
    HoldForce force;
    Vec3d velocity;  // [m/s]
    Vec3d stopped;   // what friction takes out of the way [m]
  };
  /// After the solution: `unknown` is e [m].
  End end(const Vec3d& unknown) const;

 private:
  /// τ - k_t s, where the node has come by `way` [N].
  Vec3d reach(const Vec3d& way) const;
  HoldInputs node_;
  HoldForce kept_;
  Vec3d normal_, surface_way_;  // the way of the obstacle's surface [m]
  double stiffness_ = 0, slip_stiffness_ = 0, lack_ = 0, restored_ = 0, friction_ = 0;
  bool sticks_ = false, alike_ = false;
};

}  // namespace weft::reference
