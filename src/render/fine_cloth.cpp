#include "render/fine_cloth.hpp"

#include <algorithm>

#include "mesh/subdivided_grid.hpp"

namespace weft::render {
namespace {

/// A view's values by vertex and parity: where they lie, and who names the buffer that is drawn.
struct FieldSource {
  std::array<const gpu::RawBuffer*, 2> from{};
  std::array<const gpu::RawBuffer**, 2> to{};
  std::uint32_t components = 1;
};

/// The largest buffers are those of positions and of triangles: what they fit, all others do.
Result<void> check_size(const gpu::Device& device, const ClothDraw& coarse, std::uint32_t level) {
  std::uint64_t vertices = 0, triangles = 0;
  for (const ClothRange& range : coarse.ranges) {
    if (!range.grid) return shape_error("A cloth that is not a grid cannot be drawn finer.");
    const mesh::Grid fine = mesh::subdivided(range.grid->shape, level);
    vertices += std::uint64_t{fine.nx} * fine.ny;
    triangles += 2 * std::uint64_t{fine.nx - 1} * (fine.ny - 1);
  }
  const gpu::Limits& limits = device.limits();
  const std::pair<const char*, std::uint64_t> names[] = {
      {"maxStorageBufferBindingSize", limits.max_storage_binding_size},
      {"maxBufferSize", limits.max_buffer_size}};
  const std::uint64_t bytes = std::max(vertices * sizeof(Vec4f), triangles * sizeof(mesh::Triangle));
  for (const auto& [name, limit] : names)
    if (bytes > limit)
      return make_error(ErrorKind::Limit,
                        "With render.subdivide %u the cloth has %llu vertices, and its largest buffer needs "
                        "%llu bytes, more "
                        "than this adapter's %s of %llu.",
                        level, static_cast<unsigned long long>(vertices),
                        static_cast<unsigned long long>(bytes), name, static_cast<unsigned long long>(limit));
  return {};
}

}  // namespace

Result<std::unique_ptr<FineCloth>> FineCloth::create(gpu::Device& device, const ClothDraw& coarse,
                                                     std::uint32_t level) {
  WEFT_CHECK(check_size(device, coarse, level));
  auto made = std::make_unique<FineCloth>();
  made->coarse_ = coarse;
  WEFT_CHECK(made->create_vertices(device, level));
  WEFT_CHECK(made->create_parts(device, level));
  return made;
}

Result<void> FineCloth::create_vertices(gpu::Device& device, std::uint32_t level) {
  std::vector<std::array<float, 2>> uv;
  std::vector<std::uint32_t> triangles;
  for (const ClothRange& range : coarse_.ranges) {
    const mesh::Grid fine = mesh::subdivided(range.grid->shape, level);
    const auto first_vertex = static_cast<std::uint32_t>(uv.size());
    ClothRange drawn = range;
    drawn.grid.reset();
    drawn.first_triangle = static_cast<std::uint32_t>(triangles.size() / 3);
    for (std::uint32_t j = 0; j < fine.ny; ++j)
      for (std::uint32_t i = 0; i < fine.nx; ++i) {
        const mesh::RestPoint point = mesh::rest_point(fine, i, j);
        uv.push_back({static_cast<float>(point.x), static_cast<float>(point.y)});
      }
    for (const mesh::Triangle& triangle : mesh::grid_triangles(fine))
      for (const std::uint32_t vertex : triangle) triangles.push_back(first_vertex + vertex);
    drawn.triangle_count = static_cast<std::uint32_t>(triangles.size() / 3) - drawn.first_triangle;
    draw_.ranges.push_back(drawn);
  }
  WEFT_TRY(position, gpu::Buffer<Vec4f>::create(device, uv.size(), "drawn position"));
  position_ = std::move(position);
  WEFT_TRY(normal, gpu::Buffer<Vec4f>::create(device, uv.size(), "drawn normal"));
  normal_ = std::move(normal);
  WEFT_TRY(places, (gpu::Buffer<std::array<float, 2>>::create_from(device, uv, "drawn uv")));
  uv_ = std::move(places);
  WEFT_TRY(indices, gpu::Buffer<std::uint32_t>::create_from(device, triangles, "drawn triangles",
                                                            gpu::kStorageDefault | gpu::kIndex));
  triangles_ = std::move(indices);
  draw_.position = {&position_, &position_};
  draw_.normal = &normal_;
  draw_.uv = &uv_;
  draw_.triangles = &triangles_;
  return {};
}

Result<void> FineCloth::create_parts(gpu::Device& device, std::uint32_t level) {
  WEFT_TRY(kernel, gpu::Kernel::create(device, "render/upsample_cloth.wgsl"));
  kernel_ = std::move(kernel);
  std::uint64_t vertices = 0;
  for (const ClothRange& range : coarse_.ranges) {
    const mesh::Grid& grid = range.grid->shape;
    const mesh::Grid fine = mesh::subdivided(grid, level);
    const FineGridParams params{range.grid->first_vertex, static_cast<std::uint32_t>(vertices), grid.nx,
                                grid.ny, level};
    Part part;
    part.vertex_count = std::uint64_t{fine.nx} * fine.ny;
    WEFT_SET(part.params, gpu::create_uniform(device, params, "fine grid"));
    for (std::size_t parity = 0; parity < 2; ++parity) {
      WEFT_TRY(group, kernel_.bind({part.params, *coarse_.position[parity], position_, normal_}));
      part.groups[parity] = std::move(group);
    }
    vertices += part.vertex_count;
    parts_.push_back(std::move(part));
  }
  return {};
}

Result<void> FineCloth::add_field(gpu::Device& device, scene::View view) {
  FieldSource source;
  switch (view) {
    case scene::View::Textured:
    case scene::View::Wireframe:
    case scene::View::Normals:
      return {};
    case scene::View::Stretch:
      source = {{coarse_.stretch, coarse_.stretch}, {&draw_.stretch, &draw_.stretch}, 1};
      break;
    case scene::View::Velocity:
      source = {coarse_.velocity, {&draw_.velocity[0], &draw_.velocity[1]}, 4};
      break;
    case scene::View::Contacts:
      source = {{coarse_.contacts, coarse_.contacts}, {&draw_.contacts, &draw_.contacts}, 1};
      break;
  }
  std::optional<Field>& field = fields_[static_cast<std::size_t>(view)];
  if (field || source.from[0] == nullptr || source.from[1] == nullptr) return {};
  Field made;
  WEFT_TRY(kernel, gpu::Kernel::create(device, "render/upsample_field.wgsl",
                                       {{"kComponents", static_cast<double>(source.components)}}));
  made.kernel = std::move(kernel);
  WEFT_TRY(values, gpu::RawBuffer::create(device, position_.size() * source.components * sizeof(float),
                                          gpu::kStorageDefault, "drawn field"));
  made.values = std::move(values);
  for (const Part& part : parts_) {
    std::array<gpu::BindGroup, 2> groups;
    for (std::size_t parity = 0; parity < 2; ++parity) {
      WEFT_TRY(group, made.kernel.bind({part.params, *source.from[parity], made.values}));
      groups[parity] = std::move(group);
    }
    made.groups.push_back(std::move(groups));
  }
  field = std::move(made);
  for (const gpu::RawBuffer** drawn : source.to) *drawn = &field->values;
  return {};
}

void FineCloth::record(gpu::CommandList& list, std::uint32_t parity, scene::View view) const {
  gpu::ComputePass pass(list, "upsample");
  for (const Part& part : parts_) kernel_.dispatch(pass, part.groups[parity], part.vertex_count);
  const std::optional<Field>& field = fields_[static_cast<std::size_t>(view)];
  if (!field) return;
  for (std::size_t c = 0; c < parts_.size(); ++c)
    field->kernel.dispatch(pass, field->groups[c][parity], parts_[c].vertex_count);
}

}  // namespace weft::render
