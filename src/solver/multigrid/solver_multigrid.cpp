#include "solver/multigrid/solver_multigrid.hpp"

namespace weft {

void SolverMultigrid::record_predict(gpu::ComputePass& pass) const {
  for (const GridCycle& cloth : cloths_) cloth.record(pass, kernels_);
}

void SolverMultigrid::record_solve(gpu::ComputePass& pass) const {
  if (contact_response_) contact_response_->record(pass);
  if (contact_respond_) contact_respond_->record(pass);
}

Result<std::unique_ptr<Solver>> SolverMultigrid::create(const SolverInputs& inputs) {
  auto made = std::make_unique<SolverMultigrid>();
  WEFT_TRY(kernels, MultigridKernels::create(inputs.device, inputs.workgroup_size));
  made->kernels_ = std::move(kernels);
  for (const ClothModel& cloth : inputs.model.host.cloths) {
    WEFT_TRY(cycle, GridCycle::create(inputs.device, made->kernels_, inputs.model, inputs.state,
                                      inputs.predicted(), cloth));
    made->cloths_.push_back(std::move(cycle));
  }
  if (inputs.contacts != nullptr && inputs.contacts->pairs) {
    WEFT_TRY(respond, ContactRespond::create(inputs.device, inputs.state, *inputs.contacts->pairs,
                                             inputs.workgroup_size));
    made->contact_respond_ = std::move(respond);
  } else if (inputs.contacts != nullptr) {
    WEFT_TRY(response,
             ContactResponse::create(inputs.device, inputs.state, *inputs.contacts, inputs.workgroup_size));
    made->contact_response_ = std::move(response);
  }
  return std::unique_ptr<Solver>(std::move(made));
}

}  // namespace weft
