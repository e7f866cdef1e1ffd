// The interface of contact for a solver: stages that it calls while it records a substep.
#pragma once

#include "gpu/command_list.hpp"

namespace weft::contact {

/// The stages of contact in a substep. A solver calls them where its algorithm needs them, in this order:
///
///   press      optional, before it is solved, by a solver that answers obstacles itself: their demands on each vertex.
///   press_again  optional, after press, by a solver that has worked out ways: the same by the velocities that lead
///              there, which it has left in `predicted`.
///   search     once, at the predicted state: lists near features where that is due.
///   measure    at the predicted state; again after each iteration that answers: gaps and weights of the pairs.
///   answer     optional, as often as measured: impulses between the pairs measured, added up for each vertex.
///   hold_back  owed by every solver, once, last: gives each vertex the sum of `answer`, holds it back from
///              what it would pass through, clears its words, and asks for a search where colliders go far.
///
/// Reads   position[parity], the state before the substep; position[1 - parity], the prediction.
/// Writes  position[1 - parity], velocity[1 - parity] (hold_back alone); statistics.
/// A recorded frame that breaks the order is refused (contact/stages/checked_stages.hpp). Equations: docs/contact.md.
class Stages {
 public:
  virtual ~Stages() = default;
  virtual void press(gpu::ComputePass&) const {}
  virtual void press_again(gpu::ComputePass&) const {}
  virtual void search(gpu::ComputePass&) const {}
  virtual void measure(gpu::ComputePass&) const {}
  virtual void answer(gpu::ComputePass&) const {}
  virtual void hold_back(gpu::ComputePass&) const {}
};

}  // namespace weft::contact
