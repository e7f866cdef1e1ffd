// A method's step in double: the oracle of its solver.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "contact/reference/proximity/press.hpp"
#include "method/mass_spring/reference/mass_spring.hpp"
#include "model/model.hpp"
#include "scene/scene.hpp"

namespace weft::reference {

/// What contact asks of a method whose matrix answers it.
struct Pressed {
  std::vector<NearPair> pairs;  // of one cloth, that come near
  std::vector<Press> presses;   // obstacles' demands on each node
};

/// A substep before contact.
struct Substep {
  MassSpringSystem& system;          // its state goes on by one step
  const std::vector<Vec3d>& places;  // where nodes that follow a motion are at its end [m]
  double dt = 0;                     // [s]
  double ratio = 1;                  // of dt to the step before; 0: a method with a history starts without it
  /// By velocities that take nodes to where they may end [m/s]; none: the method's matrix does not answer contact.
  std::function<Pressed(std::span<const Vec3d> velocity)> pressed = {};
  double restitution = 0;  // of what it answers
};

class Stepper {
 public:
  virtual ~Stepper() = default;
  virtual void advance(const Substep& substep) = 0;
  /// The state is not one that advance has left: nothing of the steps before counts.
  virtual void forget() {}
  /// The same for one node.
  virtual void forget(std::size_t) {}
  /// All nodes begin anew, but for the forces that obstacles hold them with.
  virtual void begin_anew() {}
  /// Cloth lies on the node, and the pairs of both bear it: what the method's matrix holds it with does not stay.
  virtual void forget_hold(std::size_t) {}
  /// Nodes whose pairs with obstacles the last step has answered in its matrix; empty: it solved without contact.
  virtual std::vector<bool> held() const { return {}; }
  /// Of each pair of the last step: the force on side A that its matrix has answered it with [N]; 0: it has not.
  virtual std::vector<Vec3d> pair_forces() const { return {}; }
};

/// Of a scene's "solver" object, whose kind is not Auto (choose_method). The model must outlive it.
std::unique_ptr<Stepper> make_stepper(const scene::Solver& settings, const Model& model, double step);

}  // namespace weft::reference
