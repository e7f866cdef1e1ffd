#include "method/mass_spring/integrate_forces.hpp"

namespace weft {

Result<IntegrateForces> IntegrateForces::create(gpu::Device& device, const Model& model, const State& state,
                                                const Predicted& predicted,
                                                const gpu::Buffer<std::int32_t>& force,
                                                std::uint32_t workgroup_size) {
  IntegrateForces made;
  WEFT_TRY(kernel,
           gpu::Kernel::create(device, "method/mass_spring/integrate_forces.wgsl", {}, workgroup_size));
  made.kernel_ = std::move(kernel);
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, made.kernel_.bind({state.steps, state.position[parity], state.velocity[parity],
                                       model.rest_position, state.motions, force, state.position[1 - parity],
                                       *predicted[parity]}));
    made.groups_[parity] = std::move(group);
  }
  made.count_ = model.vertex_count();
  return made;
}

}  // namespace weft
