#include "method/multigrid/solver_multigrid.hpp"

namespace weft {

void SolverMultigrid::record(gpu::ComputePass& pass, const contact::Stages& contact, std::uint32_t) const {
  contact.search(pass);
  contact.press(pass);
  for (const GridCycle& cloth : grids_) cloth.record(pass, kernels_);
  for (const MeshCycle& cloth : meshes_) cloth.record(pass, mesh_kernels_);
  contact.measure(pass);
  contact.answer(pass);
  contact.hold_back(pass);
}

Result<void> SolverMultigrid::add_grid(const SolverInputs& inputs, const ClothModel& cloth) {
  if (grids_.empty()) {
    WEFT_TRY(kernels,
             MultigridKernels::create(inputs.device, inputs.presses() != nullptr, inputs.workgroup_size));
    kernels_ = std::move(kernels);
  }
  WEFT_TRY(cycle, GridCycle::create(inputs.device, kernels_, inputs.model, inputs.state, inputs.predicted(),
                                    inputs.presses(), cloth));
  grids_.push_back(std::move(cycle));
  return {};
}

Result<void> SolverMultigrid::add_mesh(const SolverInputs& inputs, const ClothModel& cloth) {
  if (meshes_.empty()) {
    WEFT_TRY(kernels, MeshKernels::create(inputs.device, inputs.presses() != nullptr, inputs.workgroup_size));
    mesh_kernels_ = std::move(kernels);
  }
  WEFT_TRY(cycle, MeshCycle::create(inputs.device, mesh_kernels_, inputs.model, inputs.state,
                                    inputs.predicted(), inputs.presses(), cloth));
  meshes_.push_back(std::move(cycle));
  return {};
}

Result<std::unique_ptr<Solver>> SolverMultigrid::create(const SolverInputs& inputs) {
  auto made = std::make_unique<SolverMultigrid>();
  for (const ClothModel& cloth : inputs.model.host.cloths)
    WEFT_CHECK(cloth.grid ? made->add_grid(inputs, cloth) : made->add_mesh(inputs, cloth));
  return std::unique_ptr<Solver>(std::move(made));
}

}  // namespace weft
