#include "method/mass_spring/spring_block_forces.hpp"

namespace weft {

Result<SpringBlockForces> SpringBlockForces::create(gpu::Device& device, const Model& model,
                                                    const State& state, const std::vector<Spring>& springs,
                                                    const gpu::Buffer<std::int32_t>& force,
                                                    std::uint32_t workgroup_size) {
  SpringBlockForces made;
  WEFT_TRY(built, build_spring_blocks(model.host, springs));
  WEFT_TRY(blocks, gpu::Buffer<SpringBlock>::create_from(device, built.blocks, "spring blocks"));
  made.blocks_ = std::move(blocks);
  WEFT_TRY(nodes, gpu::Buffer<std::uint32_t>::create_from(device, built.nodes, "nodes of blocks"));
  made.nodes_ = std::move(nodes);
  WEFT_TRY(block_springs, gpu::Buffer<BlockSpring>::create_from(device, built.springs, "springs of blocks"));
  made.springs_ = std::move(block_springs);
  WEFT_TRY(kinds, gpu::Buffer<SpringKind>::create_from(device, built.kinds, "spring kinds"));
  made.kinds_ = std::move(kinds);
  WEFT_TRY(kernel,
           gpu::Kernel::create(device, "method/mass_spring/spring_block_forces.wgsl", {}, workgroup_size));
  made.kernel_ = std::move(kernel);
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, made.kernel_.bind({state.steps, state.position[parity], state.velocity[parity],
                                       made.blocks_, made.nodes_, made.springs_, made.kinds_, force}));
    made.groups_[parity] = std::move(group);
  }
  return made;
}

}  // namespace weft
