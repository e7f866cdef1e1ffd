#include "render/cloth_surface.hpp"

namespace weft::render {
namespace {

const char* entry_of(scene::View view) {
  switch (view) {
    case scene::View::Textured:
    case scene::View::Wireframe:  // has a class of its own
      break;
    case scene::View::Normals:
      return "fragment_normals";
    case scene::View::Stretch:
    case scene::View::Velocity:
    case scene::View::Contacts:
      return "fragment_field";
  }
  return "fragment_main";
}

}  // namespace

const gpu::RawBuffer& field_buffer(const ClothDraw& cloth, scene::View view, std::size_t parity) {
  switch (view) {
    case scene::View::Stretch:
      return *cloth.stretch;
    case scene::View::Velocity:
      return *cloth.velocity[parity];
    case scene::View::Contacts:
      return *cloth.contacts;
    default:
      return *cloth.uv;
  }
}

Result<ClothSurface> ClothSurface::create(gpu::Device& device, const Look& look, const ClothDraw& cloth) {
  ClothSurface made;
  gpu::RenderPipelineInfo info = picture_pipeline(look);
  info.fragment_entry = entry_of(look.view);
  const char* shader = look.view == scene::View::Textured ? "render/cloth_lit.wgsl" : "render/cloth.wgsl";
  WEFT_SET(made.pipeline_, gpu::RenderPipeline::create(device, shader, info));
  made.index_buffer_ = cloth.triangles->id();
  for (const ClothRange& range : cloth.ranges)
    made.parts_.push_back({{}, 3 * range.first_triangle, 3 * range.triangle_count});
  return made;
}

Result<void> ClothSurface::bind(std::size_t cloth, std::size_t parity,
                                std::initializer_list<gpu::Binding> sources) {
  WEFT_SET(parts_[cloth].groups[parity], pipeline_.bind(sources));
  return {};
}

void ClothSurface::record(gpu::RenderPass& pass, std::uint32_t parity) const {
  for (const Part& part : parts_)
    pass.draw_indexed(pipeline_.id(), part.groups[parity].id(), index_buffer_, part.index_count,
                      part.first_index);
}

}  // namespace weft::render
