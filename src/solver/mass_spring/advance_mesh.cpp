#include "solver/mass_spring/advance_mesh.hpp"

namespace weft {

Result<AdvanceMesh> AdvanceMesh::create(gpu::Device& device, const gpu::Kernel& kernel, const Model& model,
                                        const State& state, const Predicted& predicted,
                                        const ClothModel& cloth) {
  AdvanceMesh made;
  const Neighbours built =
      build_neighbours(build_springs(model.host, cloth), cloth.first_vertex, cloth.vertex_count);
  WEFT_TRY(offsets, gpu::Buffer<std::uint32_t>::create_from(device, built.offsets, "neighbour offsets"));
  made.offsets_ = std::move(offsets);
  WEFT_TRY(neighbours, gpu::Buffer<Neighbour>::create_from(device, built.entries, "neighbours"));
  made.neighbours_ = std::move(neighbours);
  const VertexRange range{cloth.first_vertex, cloth.vertex_count};
  WEFT_TRY(buffer, gpu::Buffer<VertexRange>::create_from(device, std::span(&range, 1), "vertex range",
                                                         gpu::kUniform | gpu::kCopyTarget));
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, kernel.bind({state.steps, buffer, made.offsets_, made.neighbours_, state.position[parity],
                                 state.velocity[parity], model.rest_position, state.motions,
                                 state.position[1 - parity], *predicted[parity]}));
    made.groups_[parity] = std::move(group);
  }
  made.range_ = std::move(buffer);
  made.count_ = cloth.vertex_count;
  return made;
}

}  // namespace weft
