#include "method/mass_spring/spring_forces.hpp"

namespace weft {

Result<SpringForces> SpringForces::create(gpu::Device& device, const State& state, const Springs& springs,
                                          const gpu::Buffer<std::int32_t>& force,
                                          std::uint32_t workgroup_size) {
  if (force.size() != 3 * state.position[0].size())
    return shape_error("Buffer force (%zu) is not three times buffer position (%zu).", force.size(),
                       state.position[0].size());
  SpringForces made;
  WEFT_TRY(packed, pack_springs(springs, atomic_order(springs),
                                static_cast<std::uint32_t>(state.position[0].size())));
  WEFT_SET(made.springs_, gpu::Buffer<PackedSpring>::create_from(device, packed.springs, "springs"));
  WEFT_SET(made.kinds_, gpu::Buffer<SpringKind>::create_from(device, packed.kinds, "spring kinds"));
  WEFT_TRY(kernel,
           gpu::create_shared_kernel(device, "method/mass_spring/spring_forces.wgsl", {}, workgroup_size));
  const gpu::Workgroups workgroups = kernel->workgroups_of(springs.size());
  WEFT_SET(made.dispatch_,
           gpu::Dispatch::create_by_parity(kernel, workgroups, [&](std::size_t p) -> gpu::Dispatch::Bindings {
             return {state.steps, state.position[p], state.velocity[p], made.springs_, made.kinds_, force};
           }));
  return made;
}

}  // namespace weft
