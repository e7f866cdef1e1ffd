#include "contact/stages/checked_stages.hpp"

namespace weft::contact {

void CheckedStages::expect(bool allowed, const char* fault) const {
  if (!allowed && fault_ == nullptr) fault_ = fault;
}

void CheckedStages::press(gpu::ComputePass& pass) const {
  expect(last_ == Stage::Begin, "presses after it has searched, or twice");
  last_ = Stage::Pressed;
  stages_.press(pass);
}

void CheckedStages::press_again(gpu::ComputePass& pass) const {
  expect(last_ == Stage::Pressed, "presses again what it has not pressed, or twice");
  last_ = Stage::PressedAgain;
  stages_.press_again(pass);
}

void CheckedStages::search(gpu::ComputePass& pass) const {
  expect(last_ == Stage::Begin || last_ == Stage::Pressed || last_ == Stage::PressedAgain, "searches twice");
  last_ = Stage::Searched;
  stages_.search(pass);
}

void CheckedStages::measure(gpu::ComputePass& pass) const {
  expect(last_ == Stage::Searched || last_ == Stage::Answered, "measures before it has searched, or twice");
  last_ = Stage::Measured;
  stages_.measure(pass);
}

void CheckedStages::answer(gpu::ComputePass& pass) const {
  expect(last_ == Stage::Measured, "answers what it has not measured");
  last_ = Stage::Answered;
  stages_.answer(pass);
}

void CheckedStages::hold_back(gpu::ComputePass& pass) const {
  expect(last_ == Stage::Measured || last_ == Stage::Answered,
         "holds back what it has not measured, or twice");
  last_ = Stage::HeldBack;
  stages_.hold_back(pass);
}

Result<void> CheckedStages::end_substep() {
  expect(last_ == Stage::HeldBack, "does not end with holding vertices back");
  const char* fault = fault_;
  last_ = Stage::Begin;
  fault_ = nullptr;
  if (fault == nullptr) return {};
  return make_error(ErrorKind::Failure, "The solver's substep breaks the contract of contact: it %s.", fault);
}

}  // namespace weft::contact
