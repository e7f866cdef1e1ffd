#include "state/surface.hpp"

#include <algorithm>

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
  WEFT_CHECK(made.create_pattern(device, model.host));
  for (const Body& body : model.host.bodies) {
    ClothPart part;
    part.cut_from_pattern = body.pattern.has_value();
    const gpu::Buffer<Vec4f>& rest = part.cut_from_pattern ? made.pattern_ : model.rest_position;
    const gpu::Kernel& of_part = part.cut_from_pattern ? made.pattern_kernel_ : made.kernel_;
    part.vertex_count = body.vertex_count;
    const SurfaceParams params{body.first_vertex, body.vertex_count, body.row()};
    WEFT_TRY(buffer, gpu::create_uniform(device, params, "surface params"));
    for (std::size_t parity = 0; parity < 2; ++parity) {
      WEFT_TRY(group, of_part.bind({buffer, state.position[parity], rest, model.triangles, made.offsets_,
                                    made.around_, made.normal_, made.stretch_, state.statistics}));
      part.groups[parity] = std::move(group);
    }
    part.params = std::move(buffer);
    made.parts_.push_back(std::move(part));
  }
  WEFT_CHECK(made.create_flattened(device, model, state));
  return made;
}

Result<void> Surface::create_pattern(gpu::Device& device, const Model& model) {
  if (std::none_of(model.bodies.begin(), model.bodies.end(),
                   [](const Body& body) { return body.pattern.has_value(); }))
    return {};
  std::vector<Vec4f> places;
  for (const Body& body : model.bodies)
    for (std::uint32_t t = 0; t < body.triangle_count; ++t)
      for (const Vec3d& corner : rest_corners(model, body, t))
        places.push_back(Vec4f::from(corner.to<float>(), 0));
  WEFT_SET(pattern_, gpu::Buffer<Vec4f>::create_from(device, places, "pattern"));
  WEFT_SET(pattern_kernel_, gpu::Kernel::create(device, "state/surface.wgsl", {{"kCutFromPattern", 1}}));
  return {};
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
  for (const ClothPart& part : parts_) {
    const gpu::Kernel& kernel = part.cut_from_pattern ? pattern_kernel_ : kernel_;
    kernel.dispatch(pass, part.groups[pass.parity()], part.vertex_count);
  }
  flattened_.record(pass);
}

}  // namespace weft
