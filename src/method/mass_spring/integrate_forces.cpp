#include "method/mass_spring/integrate_forces.hpp"

namespace weft {

Result<IntegrateForces> IntegrateForces::create(const SolverInputs& inputs,
                                                const gpu::Buffer<std::int32_t>& force) {
  const State& state = inputs.state;
  WEFT_TRY(kernel, gpu::create_shared_kernel(inputs.device, "method/mass_spring/integrate_forces.wgsl", {},
                                             inputs.workgroup_size));
  const gpu::Workgroups workgroups = kernel->workgroups_of(inputs.model.vertex_count());
  IntegrateForces made;
  WEFT_SET(made.dispatch_,
           gpu::Dispatch::create_by_parity(kernel, workgroups, [&](std::size_t p) -> gpu::Dispatch::Bindings {
             return {state.steps,           state.position[p],
                     state.velocity[p],     inputs.model.rest_position,
                     state.motions,         force,
                     state.position[1 - p], *inputs.predicted()[p]};
           }));
  return made;
}

}  // namespace weft
