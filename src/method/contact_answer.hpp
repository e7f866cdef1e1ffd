#pragma once

#include <optional>

#include "contact/proximity/contact_respond.hpp"
#include "contact/pushes/contact_response.hpp"
#include "method/solver.hpp"

namespace weft {

/// What a solver does about the contacts found at its predicted positions: the mean of pushes (Algorithm 2)
/// or impulses between pairs (docs/contact.md), by what the scene's contact method finds; nothing without
/// contact.
class ContactAnswer {
 public:
  /// Errors  Shader, OutOfMemory.
  static Result<ContactAnswer> create(const SolverInputs& inputs, scene::SolverKind kind);
  /// Takes over lists of pairs with other room. Errors  OutOfMemory.
  Result<void> bind_lists(const State& state, const ContactPairs& pairs);
  void record(gpu::ComputePass& pass) const;

 private:
  std::optional<ContactResponse> response_;  // to pushes
  std::optional<ContactRespond> respond_;    // to pairs
};

}  // namespace weft
