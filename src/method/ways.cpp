#include "method/ways.hpp"

#include "method/corners.hpp"

namespace weft {

Result<gpu::Buffer<std::uint32_t>> corners_in_air(const SolverInputs& inputs) {
  if (inputs.air) return air_corners(inputs.device, inputs.model.host);
  return gpu::Buffer<std::uint32_t>::create(inputs.device, 1, "no corners around");
}

Result<GasOnWays> GasOnWays::create(const SolverInputs& inputs, const WayOf& way_of) {
  GasOnWays made;
  WEFT_SET(made.gas_, EnclosedGas::create(inputs, EnclosedGas::At::Start));
  if (!made.gas_.any()) return made;
  WEFT_TRY(kernel,
           gpu::create_shared_kernel(inputs.device, "method/begin_way.wgsl", {}, inputs.workgroup_size));
  WEFT_SET(made.begin_way_,
           gpu::Dispatch::create_by_parity(kernel, kernel->workgroups_of(inputs.model.vertex_count()),
                                           [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                             return {made.gas_.gases(), made.gas_.slopes(), way_of(p)};
                                           }));
  return made;
}

std::vector<gpu::Constant> GasOnWays::pushes(const SolverInputs& inputs) const {
  return {{"kAirPushes", inputs.air ? 1.0 : 0.0}, {"kGasPushes", gas_.any() ? 1.0 : 0.0}};
}

Result<gpu::Dispatch> create_start_way(const SolverInputs& inputs, const gpu::Buffer<std::uint32_t>& corners,
                                       const GasOnWays& gas, const gpu::Buffer<Vec4f>& aim,
                                       const WayOf& way_of) {
  const State& state = inputs.state;
  WEFT_TRY(kernel, gpu::create_shared_kernel(inputs.device, "method/start_way.wgsl", gas.pushes(inputs),
                                             inputs.workgroup_size));
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
