#include "method/mass_spring/advance_mesh.hpp"

namespace weft {

Result<AdvanceMesh> AdvanceMesh::create(gpu::Device& device, const Model& model, const State& state,
                                        const Predicted& predicted, const ClothModel& cloth,
                                        std::uint32_t workgroup_size) {
  AdvanceMesh made;
  WEFT_TRY(built, build_neighbours(build_springs(model.host, cloth), cloth.first_vertex, cloth.vertex_count));
  WEFT_TRY(slices, gpu::Buffer<std::uint32_t>::create_from(device, built.slices, "neighbour slices"));
  made.slices_ = std::move(slices);
  WEFT_TRY(neighbours, gpu::Buffer<Neighbour>::create_from(device, built.entries, "neighbours"));
  made.neighbours_ = std::move(neighbours);
  MeshParams params;
  params.first = cloth.first_vertex;
  params.count = cloth.vertex_count;
  for (std::size_t kind = 0; kind < built.kinds.size(); ++kind)
    params.kinds[kind] = {built.kinds[kind].stiffness, built.kinds[kind].damping, 0, 0};
  WEFT_TRY(buffer, gpu::Buffer<MeshParams>::create_from(device, std::span(&params, 1), "mesh params",
                                                        gpu::kUniform | gpu::kCopyTarget));
  const double damped = cloth.damping > 0 ? 1 : 0;
  WEFT_TRY(kernel, gpu::Kernel::create(device, "method/mass_spring/advance_mesh.wgsl", {{"kDamped", damped}},
                                       workgroup_size));
  made.kernel_ = std::move(kernel);
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, made.kernel_.bind({state.steps, buffer, made.slices_, made.neighbours_,
                                       state.position[parity], state.velocity[parity], model.rest_position,
                                       state.motions, state.position[1 - parity], *predicted[parity]}));
    made.groups_[parity] = std::move(group);
  }
  made.params_ = std::move(buffer);
  made.count_ = cloth.vertex_count;
  return made;
}

}  // namespace weft
