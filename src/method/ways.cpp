#include "method/ways.hpp"

#include "method/corners.hpp"

namespace weft {

Result<gpu::Buffer<std::uint32_t>> corners_in_air(const SolverInputs& inputs) {
  if (inputs.air) return air_corners(inputs.device, inputs.model.host);
  return gpu::Buffer<std::uint32_t>::create(inputs.device, 1, "no corners around");
}

Result<gpu::Dispatch> create_start_way(const SolverInputs& inputs, const gpu::Buffer<std::uint32_t>& corners,
                                       const gpu::Buffer<Vec4f>& aim,
                                       const std::function<const gpu::Buffer<Vec4f>&(std::size_t)>& way_of) {
  const State& state = inputs.state;
  WEFT_TRY(kernel,
           gpu::create_shared_kernel(inputs.device, "method/start_way.wgsl",
                                     {{"kAirPushes", inputs.air ? 1.0 : 0.0}}, inputs.workgroup_size));
  return gpu::Dispatch::create_by_parity(kernel, kernel->workgroups_of(inputs.model.vertex_count()),
                                         [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                           return {state.steps,
                                                   state.position[p],
                                                   state.velocity[p],
                                                   state.velocity[1 - p],
                                                   inputs.model.rest_position,
                                                   state.motions,
                                                   aim,
                                                   way_of(p),
                                                   corners};
                                         });
}

Result<gpu::Dispatch> create_end_way(const SolverInputs& inputs, bool history) {
  const State& state = inputs.state;
  WEFT_TRY(kernel, gpu::create_shared_kernel(inputs.device, "method/end_way.wgsl",
                                             {{"kHistory", history ? 1.0 : 0.0}}, inputs.workgroup_size));
  return gpu::Dispatch::create_by_parity(
      kernel, kernel->workgroups_of(inputs.model.vertex_count()),
      [&](std::size_t p) -> gpu::Dispatch::Bindings {
        return {state.steps, state.position[p], state.position[1 - p], *inputs.predicted()[p]};
      });
}

}  // namespace weft
