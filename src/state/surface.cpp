#include "state/surface.hpp"

#include "mesh/adjacency.hpp"

namespace weft {

Result<Surface> Surface::create(gpu::Device& device, const GpuModel& model, const State& state) {
  Surface made;
  WEFT_TRY(kernel, gpu::Kernel::create(device, "state/surface.wgsl"));
  made.kernel_ = std::move(kernel);
  WEFT_TRY(normal, gpu::Buffer<Vec4f>::create(device, model.vertex_count(), "normal", gpu::kVertexStorage));
  made.normal_ = std::move(normal);
  WEFT_TRY(stretch, gpu::Buffer<float>::create(device, model.vertex_count(), "stretch", gpu::kVertexStorage));
  made.stretch_ = std::move(stretch);
  const mesh::Adjacency adjacency = mesh::triangle_adjacency(model.vertex_count(), model.host.triangles);
  WEFT_TRY(offsets, gpu::Buffer<std::uint32_t>::create_from(device, adjacency.offsets, "triangle offsets"));
  made.offsets_ = std::move(offsets);
  WEFT_TRY(around, gpu::Buffer<std::uint32_t>::create_from(device, adjacency.entries, "triangles around"));
  made.around_ = std::move(around);
  for (const Body& body : model.host.bodies) {
    ClothPart part;
    part.vertex_count = body.vertex_count;
    const SurfaceParams params{body.first_vertex, body.vertex_count, body.row()};
    WEFT_TRY(buffer, gpu::create_uniform(device, params, "surface params"));
    for (std::size_t parity = 0; parity < 2; ++parity) {
      WEFT_TRY(group, made.kernel_.bind({buffer, state.position[parity], model.rest_position, model.triangles,
                                         made.offsets_, made.around_, made.normal_, made.stretch_,
                                         state.statistics}));
      part.groups[parity] = std::move(group);
    }
    part.params = std::move(buffer);
    made.parts_.push_back(std::move(part));
  }
  WEFT_CHECK(made.create_flattened(device, model, state));
  return made;
}

Result<void> Surface::create_flattened(gpu::Device& device, const GpuModel& model, const State& state) {
  const ElementTable& tets = model.host.elements(ElementKind::Tet);
  if (tets.size() == 0) return {};
  WEFT_SET(tets_, (gpu::Buffer<std::array<std::uint32_t, 4>>::create_from(device, nodes_by_four(tets),
                                                                          "tetrahedra")));
  WEFT_TRY(kernel, gpu::create_shared_kernel(device, "state/flattened.wgsl", {}, gpu::kDefaultWorkgroupSize));
  WEFT_SET(flattened_,
           gpu::Dispatch::create_by_parity(
               kernel, kernel->workgroups_of(tets.size()), [&](std::size_t p) -> gpu::Dispatch::Bindings {
                 return {state.position[p], model.rest_position, tets_, state.statistics};
               }));
  return {};
}

void Surface::record(gpu::ComputePass& pass) const {
  for (const ClothPart& part : parts_) kernel_.dispatch(pass, part.groups[pass.parity()], part.vertex_count);
  flattened_.record(pass);
}

}  // namespace weft
