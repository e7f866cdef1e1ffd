#include "state/surface.hpp"

#include "mesh/adjacency.hpp"

namespace weft {

Result<Surface> Surface::create(gpu::Device& device, const GpuModel& model, const State& state) {
  Surface made;
  WEFT_TRY(kernel, gpu::Kernel::create(device, "state/surface.wgsl"));
  made.kernel_ = std::move(kernel);
  WEFT_TRY(normal, gpu::Buffer<Vec4f>::create(device, model.vertex_count(), "normal"));
  made.normal_ = std::move(normal);
  WEFT_TRY(stretch, gpu::Buffer<float>::create(device, model.vertex_count(), "stretch"));
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
  return made;
}

void Surface::record(gpu::ComputePass& pass) const {
  for (const ClothPart& part : parts_) kernel_.dispatch(pass, part.groups[pass.parity()], part.vertex_count);
}

}  // namespace weft
