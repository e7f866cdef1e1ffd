#pragma once

#include "base/result.hpp"
#include "contact/stages/stages.hpp"

namespace weft::contact {

/// Forwards each stage and checks the order of the calls, so that a solver that violates contact's contract is
/// refused when its frame is recorded, before it runs.
class CheckedStages : public Stages {
 public:
  explicit CheckedStages(const Stages& stages) : stages_(stages) {}

  void press(gpu::ComputePass& pass) const override;
  void press_again(gpu::ComputePass& pass) const override;
  void search(gpu::ComputePass& pass) const override;
  void measure(gpu::ComputePass& pass) const override;
  void answer(gpu::ComputePass& pass) const override;
  void hold_back(gpu::ComputePass& pass) const override;

  /// After a substep was recorded; the next one may follow. Errors  Failure: the first rule that it broke.
  Result<void> end_substep();

 private:
  enum class Stage { Begin, Pressed, PressedAgain, Searched, Measured, Answered, HeldBack };
  void expect(bool allowed, const char* fault) const;

  const Stages& stages_;
  mutable Stage last_ = Stage::Begin;
  mutable const char* fault_ = nullptr;
};

}  // namespace weft::contact
