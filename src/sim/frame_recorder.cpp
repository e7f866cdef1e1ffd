#include "sim/frame_recorder.hpp"

#include "contact/stages/checked_stages.hpp"

namespace weft::sim {

Result<FrameRecorder> FrameRecorder::create(const State& state, const Solver& solver,
                                            const contact::SceneContact& contact, const LastGood& last_good,
                                            const Surface& surface) {
  FrameRecorder made;
  made.state_ = &state;
  made.solver_ = &solver;
  made.contact_ = &contact;
  made.last_good_ = &last_good;
  made.surface_ = &surface;
  if (contact.contacts() == nullptr) return made;  // nothing is owed
  contact::CheckedStages checked(contact.stages());
  gpu::CommandList list;
  gpu::ComputePass pass(list, "check");
  solver.record(pass, checked, 1);
  WEFT_CHECK(checked.end_substep());
  return made;
}

std::uint32_t FrameRecorder::turns_of(std::uint32_t substeps) const {
  const std::uint32_t at_once = solver_->substeps_at_once();
  return (substeps + at_once - 1) / at_once;
}

void FrameRecorder::record(gpu::CommandList& list, std::uint32_t parity, std::uint32_t substeps) const {
  list.clear(state_->statistics.range(0, kStatisticsPerFrameBytes));
  gpu::ComputePass pass(list, "frame");
  pass.begin_phase("step");
  const std::uint32_t at_once = solver_->substeps_at_once();
  for (std::uint32_t s = 0, turns = 0; s < substeps; ++turns) {
    const std::uint32_t count = s + at_once <= substeps ? at_once : 1;
    pass.set_step(s, (parity + turns) & 1U);
    solver_->record(pass, contact_->stages(), count);
    s += count;
  }
  pass.begin_phase("frame");
  pass.set_step(0, (parity + turns_of(substeps)) & 1U);
  last_good_->record(pass);
  contact_->end_frame(pass);
  surface_->record(pass);
  contact_->record_counts(pass);
}

const gpu::CommandList& FrameRecorder::commands(std::uint32_t parity, std::uint32_t substeps) {
  gpu::CommandList& list = lists_[substeps][parity];
  if (list.commands().empty()) record(list, parity, substeps);
  return list;
}

}  // namespace weft::sim
