#include "method/mass_spring/spring_block_forces.hpp"

namespace weft {

Result<SpringBlockForces> SpringBlockForces::create(gpu::Device& device, const GpuModel& model,
                                                    const State& state, const Springs& springs,
                                                    const gpu::Buffer<std::int32_t>& force,
                                                    std::uint32_t workgroup_size) {
  SpringBlockForces made;
  WEFT_TRY(built, build_spring_blocks(model.host.rest_position, springs));
  WEFT_SET(made.blocks_, gpu::Buffer<SpringBlock>::create_from(device, built.blocks, "spring blocks"));
  WEFT_SET(made.nodes_, gpu::Buffer<std::uint32_t>::create_from(device, built.nodes, "nodes of blocks"));
  WEFT_SET(made.springs_, gpu::Buffer<BlockSpring>::create_from(device, built.springs, "springs of blocks"));
  WEFT_SET(made.kinds_, gpu::Buffer<SpringKind>::create_from(device, built.kinds, "spring kinds"));
  WEFT_TRY(kernel, gpu::create_shared_kernel(device, "method/mass_spring/spring_block_forces.wgsl", {},
                                             workgroup_size));
  const gpu::Workgroups workgroups = kernel->workgroups_of(built.blocks.size() * workgroup_size);
  WEFT_SET(made.dispatch_,
           gpu::Dispatch::create_by_parity(kernel, workgroups, [&](std::size_t p) -> gpu::Dispatch::Bindings {
             return {state.steps, state.position[p], state.velocity[p], made.blocks_,
                     made.nodes_, made.springs_,     made.kinds_,       force};
           }));
  return made;
}

}  // namespace weft
