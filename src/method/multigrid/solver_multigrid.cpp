#include "method/multigrid/solver_multigrid.hpp"

#include <optional>

namespace weft {

void SolverMultigrid::record(gpu::ComputePass& pass, const contact::Stages& contact, std::uint32_t) const {
  contact.search(pass);
  contact.press(pass);
  for (const GridCycle& cycle : grids_) cycle.record(pass);
  for (const MeshCycle& cycle : meshes_) cycle.record(pass);
  contact.measure(pass);
  contact.answer(pass);
  contact.hold_back(pass);
}

Result<void> SolverMultigrid::create_cycles(const CycleInputs& inputs) {
  std::optional<GridKernels> grid_kernels;
  std::optional<MeshKernels> mesh_kernels;
  for (const Body& body : inputs.model.host.bodies) {
    if (body.grid) {
      if (!grid_kernels) WEFT_SET(grid_kernels, GridKernels::create(inputs));
      WEFT_TRY(cycle, GridCycle::create(inputs, *grid_kernels, body));
      grids_.push_back(std::move(cycle));
    } else {
      if (!mesh_kernels) WEFT_SET(mesh_kernels, MeshKernels::create(inputs));
      WEFT_TRY(cycle, MeshCycle::create(inputs, *mesh_kernels, body));
      meshes_.push_back(std::move(cycle));
    }
  }
  return {};
}

Result<std::unique_ptr<Solver>> SolverMultigrid::create(const SolverInputs& inputs) {
  auto made = std::make_unique<SolverMultigrid>();
  WEFT_CHECK(made->create_cycles({inputs.device, inputs.model, inputs.state, inputs.predicted(),
                                  inputs.presses(), inputs.workgroup_size}));
  return std::unique_ptr<Solver>(std::move(made));
}

}  // namespace weft
