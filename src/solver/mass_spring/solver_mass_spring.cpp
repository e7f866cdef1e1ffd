#include "solver/mass_spring/solver_mass_spring.hpp"

#include <algorithm>

namespace weft {

void SolverMassSpring::record_predict(gpu::ComputePass& pass) const {
  if (spring_centric_) {
    spring_centric_->spring_forces.record(pass);     // Algorithm 1
    spring_centric_->integrate_forces.record(pass);  // gravity enters here, so it needs no buffer
    return;
  }
  for (const AdvanceGrid& cloth : node_centric_->grids) cloth.record(pass, node_centric_->grid_kernel);
  for (const AdvanceMesh& cloth : node_centric_->meshes) cloth.record(pass, node_centric_->mesh_kernel);
}

void SolverMassSpring::record_solve(gpu::ComputePass& pass) const {
  if (contact_response_) contact_response_->record(pass);  // Algorithm 2
  if (contact_respond_) contact_respond_->record(pass);    // docs/contact.md
}

Result<void> SolverMassSpring::create_spring_centric(const SolverInputs& inputs) {
  SpringCentric made;
  const std::vector<Spring> springs = build_springs(inputs.model.host);
  const ForceFixedPoint fixed_point = force_fixed_point(springs, inputs.model.vertex_count());
  constants_ = {static_cast<std::uint32_t>(springs.size()), fixed_point.scale, fixed_point.limit};
  WEFT_TRY(spring_buffer, gpu::Buffer<Spring>::create_from(inputs.device, springs, "springs"));
  made.springs = std::move(spring_buffer);
  WEFT_TRY(force,
           gpu::Buffer<std::int32_t>::create(inputs.device, 3UL * inputs.model.vertex_count(), "force"));
  made.force = std::move(force);
  WEFT_TRY(forces, SpringForces::create(inputs.device, inputs.state, made.springs, made.force,
                                        inputs.workgroup_size));
  made.spring_forces = std::move(forces);
  WEFT_TRY(integrate, IntegrateForces::create(inputs.device, inputs.model, inputs.state, inputs.predicted(),
                                              made.force, inputs.workgroup_size));
  made.integrate_forces = std::move(integrate);
  spring_centric_ = std::move(made);
  return {};
}

Result<void> SolverMassSpring::create_node_centric(const SolverInputs& inputs) {
  NodeCentric made;
  const auto& cloths = inputs.model.host.cloths;
  const auto is_grid = [](const ClothModel& cloth) { return cloth.grid.has_value(); };
  if (std::any_of(cloths.begin(), cloths.end(), is_grid)) {
    WEFT_TRY(kernel, AdvanceGrid::kernel(inputs.device, inputs.workgroup_size));
    made.grid_kernel = std::move(kernel);
  }
  if (!std::all_of(cloths.begin(), cloths.end(), is_grid)) {
    WEFT_TRY(kernel, AdvanceMesh::kernel(inputs.device, inputs.workgroup_size));
    made.mesh_kernel = std::move(kernel);
  }
  for (const ClothModel& cloth : cloths) {
    if (is_grid(cloth)) {
      WEFT_TRY(advance, AdvanceGrid::create(inputs.device, made.grid_kernel, inputs.model, inputs.state,
                                            inputs.predicted(), cloth));
      made.grids.push_back(std::move(advance));
    } else {
      WEFT_TRY(advance, AdvanceMesh::create(inputs.device, made.mesh_kernel, inputs.model, inputs.state,
                                            inputs.predicted(), cloth));
      made.meshes.push_back(std::move(advance));
    }
  }
  node_centric_ = std::move(made);
  return {};
}

Result<std::unique_ptr<Solver>> SolverMassSpring::create(const scene::Solver& settings,
                                                         const SolverInputs& inputs) {
  auto made = std::make_unique<SolverMassSpring>();
  if (settings.forces == scene::Forces::SpringCentric) {
    WEFT_CHECK(made->create_spring_centric(inputs));
  } else {
    WEFT_CHECK(made->create_node_centric(inputs));
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
