#include "method/holds/held_ways.hpp"

namespace weft {

std::size_t aim_words(const SolverInputs& inputs) {
  return std::size_t{inputs.presses() != nullptr ? 4U : 1U} * inputs.model.vertex_count();
}

std::vector<gpu::Constant> holds_constant(const SolverInputs& inputs) {
  return {{"kHolds", inputs.presses() != nullptr ? 1.0 : 0.0}};
}

Result<gpu::Dispatch> create_begin_holds(const SolverInputs& inputs, const gpu::Buffer<Vec4f>& aim,
                                         const WayOf& way_of) {
  if (inputs.presses() == nullptr) return gpu::Dispatch();
  const State& state = inputs.state;
  WEFT_TRY(kernel, gpu::create_shared_kernel(inputs.device, "method/holds/begin_holds.wgsl", {},
                                             inputs.workgroup_size));
  return gpu::Dispatch::create_by_parity(
      kernel, kernel->workgroups_of(inputs.model.vertex_count()),
      [&](std::size_t p) -> gpu::Dispatch::Bindings {
        return {state.steps, state.velocity[p], state.velocity[1 - p], *inputs.presses(), aim, way_of(p)};
      });
}

Result<gpu::Dispatch> create_end_held_way(const SolverInputs& inputs, const gpu::Buffer<Vec4f>& aim,
                                          bool history) {
  if (inputs.presses() == nullptr) return create_end_way(inputs, history);
  const State& state = inputs.state;
  WEFT_TRY(kernel, gpu::create_shared_kernel(inputs.device, "method/holds/end_held_way.wgsl",
                                             {{"kHistory", history ? 1.0 : 0.0}}, inputs.workgroup_size));
  return gpu::Dispatch::create_by_parity(
      kernel, kernel->workgroups_of(inputs.model.vertex_count()),
      [&](std::size_t p) -> gpu::Dispatch::Bindings {
        return {state.steps, state.position[p], state.position[1 - p], *inputs.predicted()[p], aim};
      });
}

}  // namespace weft
