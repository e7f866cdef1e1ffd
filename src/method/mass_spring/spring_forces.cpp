#include "method/mass_spring/spring_forces.hpp"

namespace weft {

Result<SpringForces> SpringForces::create(gpu::Device& device, const State& state,
                                          const std::vector<Spring>& springs,
                                          const gpu::Buffer<std::int32_t>& force,
                                          std::uint32_t workgroup_size) {
  if (force.size() != 3 * state.position[0].size())
    return shape_error("Buffer force (%zu) is not three times buffer position (%zu).", force.size(),
                       state.position[0].size());
  SpringForces made;
  WEFT_TRY(packed, pack_springs(springs, static_cast<std::uint32_t>(state.position[0].size())));
  WEFT_TRY(spring_buffer, gpu::Buffer<PackedSpring>::create_from(device, packed.springs, "springs"));
  made.springs_ = std::move(spring_buffer);
  WEFT_TRY(kinds, gpu::Buffer<SpringKind>::create_from(device, packed.kinds, "spring kinds"));
  made.kinds_ = std::move(kinds);
  WEFT_TRY(kernel, gpu::Kernel::create(device, "method/mass_spring/spring_forces.wgsl", {}, workgroup_size));
  made.kernel_ = std::move(kernel);
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, made.kernel_.bind({state.steps, state.position[parity], state.velocity[parity],
                                       made.springs_, made.kinds_, force}));
    made.groups_[parity] = std::move(group);
  }
  made.count_ = springs.size();
  return made;
}

}  // namespace weft
