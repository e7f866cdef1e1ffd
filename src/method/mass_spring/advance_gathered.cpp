#include "method/mass_spring/advance_gathered.hpp"

namespace weft {

Result<gpu::Dispatch> create_advance_gathered(const SolverInputs& inputs, const gpu::RawBuffer& nodes,
                                              std::uint32_t count, const gpu::Buffer<std::uint32_t>& gathers,
                                              const gpu::Buffer<Vec4f>& forces) {
  const State& state = inputs.state;
  WEFT_TRY(kernel, gpu::create_shared_kernel(inputs.device, "method/mass_spring/advance_gathered.wgsl", {},
                                             inputs.workgroup_size));
  return gpu::Dispatch::create_by_parity(kernel, kernel->workgroups_of(count),
                                         [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                           return {state.steps,
                                                   nodes,
                                                   gathers,
                                                   forces,
                                                   state.position[p],
                                                   state.velocity[p],
                                                   inputs.model.rest_position,
                                                   state.motions,
                                                   state.position[1 - p],
                                                   *inputs.predicted()[p]};
                                         });
}

}  // namespace weft
