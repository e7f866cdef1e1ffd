// What a solver owes contact (contact/stages/stages.hpp), and that a solver that forgets it is refused.
#include <doctest/doctest.h>

#include <functional>
#include <string>
#include <vector>

#include "contact/stages/checked_stages.hpp"

using namespace weft;
using contact::Stages;

namespace {

/// Notes which stages were recorded.
class Notes : public Stages {
 public:
  void search(gpu::ComputePass&) const override { text += "search "; }
  void press(gpu::ComputePass&) const override { text += "press "; }
  void press_again(gpu::ComputePass&) const override { text += "press_again "; }
  void measure(gpu::ComputePass&) const override { text += "measure "; }
  void answer(gpu::ComputePass&) const override { text += "answer "; }
  void hold_back(gpu::ComputePass&) const override { text += "hold_back "; }
  mutable std::string text;
};

using Substep = std::vector<void (Stages::*)(gpu::ComputePass&) const>;
constexpr auto kSearch = &Stages::search;
constexpr auto kPress = &Stages::press;
constexpr auto kPressAgain = &Stages::press_again;
constexpr auto kMeasure = &Stages::measure;
constexpr auto kAnswer = &Stages::answer;
constexpr auto kHoldBack = &Stages::hold_back;

/// The sentence that a substep of these calls is refused with; "" where it is accepted.
std::string refusal_of(const Substep& substep) {
  gpu::CommandList list;
  gpu::ComputePass pass(list, "substep");
  const Notes notes;
  contact::CheckedStages checked(notes);
  for (const auto stage : substep) (checked.*stage)(pass);
  const auto done = checked.end_substep();
  return done ? "" : done.error().message;
}

}  // namespace

TEST_CASE("a substep that calls the stages of contact in their order is recorded as it is") {
  CHECK(refusal_of({kSearch, kMeasure, kHoldBack}) == "");
  CHECK(refusal_of({kSearch, kMeasure, kAnswer, kHoldBack}) == "");
  CHECK(refusal_of({kPress, kSearch, kMeasure, kAnswer, kHoldBack}) == "");
  CHECK(refusal_of({kPress, kPressAgain, kSearch, kMeasure, kAnswer, kHoldBack}) == "");
  CHECK(refusal_of({kSearch, kMeasure, kAnswer, kMeasure, kAnswer, kHoldBack}) == "");
  gpu::CommandList list;
  gpu::ComputePass pass(list, "substep");
  const Notes notes;
  contact::CheckedStages checked(notes);
  for (const auto stage : Substep{kPress, kPressAgain, kSearch, kMeasure, kAnswer, kHoldBack})
    (checked.*stage)(pass);
  CHECK(notes.text == "press press_again search measure answer hold_back ");
}

TEST_CASE("a solver that forgets what it owes contact is refused with what it broke") {
  const std::string begin = "The solver's substep breaks the contract of contact: it ";
  CHECK(refusal_of({}) == begin + "does not end with holding vertices back.");
  CHECK(refusal_of({kSearch}) == begin + "does not end with holding vertices back.");
  CHECK(refusal_of({kSearch, kMeasure}) == begin + "does not end with holding vertices back.");
  CHECK(refusal_of({kSearch, kMeasure, kAnswer}) == begin + "does not end with holding vertices back.");
  CHECK(refusal_of({kSearch, kHoldBack}) == begin + "holds back what it has not measured, or twice.");
  CHECK(refusal_of({kMeasure, kHoldBack}) == begin + "measures before it has searched, or twice.");
  CHECK(refusal_of({kSearch, kAnswer, kMeasure, kHoldBack}) == begin + "answers what it has not measured.");
  CHECK(refusal_of({kSearch, kPress, kMeasure, kHoldBack}) ==
        begin + "presses after it has searched, or twice.");
  CHECK(refusal_of({kPress, kPress, kSearch, kMeasure, kHoldBack}) ==
        begin + "presses after it has searched, or twice.");
  CHECK(refusal_of({kPressAgain, kSearch, kMeasure, kHoldBack}) ==
        begin + "presses again what it has not pressed, or twice.");
  CHECK(refusal_of({kPress, kPressAgain, kPressAgain, kSearch, kMeasure, kHoldBack}) ==
        begin + "presses again what it has not pressed, or twice.");
  CHECK(refusal_of({kSearch, kSearch, kMeasure, kHoldBack}) == begin + "searches twice.");
  CHECK(refusal_of({kSearch, kMeasure, kHoldBack, kHoldBack}) ==
        begin + "holds back what it has not measured, or twice.");
}

TEST_CASE("the order is watched anew in each substep") {
  gpu::CommandList list;
  gpu::ComputePass pass(list, "substeps");
  const Notes notes;
  contact::CheckedStages checked(notes);
  CHECK_FALSE(checked.end_substep());
  for (const auto stage : Substep{kSearch, kMeasure, kHoldBack}) (checked.*stage)(pass);
  CHECK(checked.end_substep());
  CHECK_FALSE(checked.end_substep());
}
