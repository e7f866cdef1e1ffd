#include "solver/multigrid/solver_multigrid.hpp"

namespace weft {

void SolverMultigrid::record_predict(gpu::ComputePass& pass) const {
  for (const GridCycle& cloth : cloths_) cloth.record(pass, kernels_);
}

void SolverMultigrid::record_solve(gpu::ComputePass& pass) const { contact_answer_.record(pass); }

Result<std::unique_ptr<Solver>> SolverMultigrid::create(const SolverInputs& inputs) {
  auto made = std::make_unique<SolverMultigrid>();
  WEFT_TRY(kernels,
           MultigridKernels::create(inputs.device, inputs.presses() != nullptr, inputs.workgroup_size));
  made->kernels_ = std::move(kernels);
  for (const ClothModel& cloth : inputs.model.host.cloths) {
    WEFT_TRY(cycle, GridCycle::create(inputs.device, made->kernels_, inputs.model, inputs.state,
                                      inputs.predicted(), inputs.presses(), cloth));
    made->cloths_.push_back(std::move(cycle));
  }
  WEFT_TRY(answer, ContactAnswer::create(inputs, scene::SolverKind::Multigrid));
  made->contact_answer_ = std::move(answer);
  return std::unique_ptr<Solver>(std::move(made));
}

}  // namespace weft
