#include "render/view_passes.hpp"

namespace weft::render {

Result<ViewPasses> ViewPasses::create(gpu::Device& device, const Look& look, const DrawnScene& scene) {
  ViewPasses made;
  made.view_ = look.view;
  const bool textured = look.view == scene::View::Textured;
  if (look.view == scene::View::Wireframe) {
    WEFT_TRY(cloth, ClothWireframe::create(device, look, scene.frame, scene.fabrics, scene.cloth));
    made.cloth_wireframe_ = std::move(cloth);
  } else {
    WEFT_SET(made.cloth_surface_, ClothSurface::create(device, look, scene.cloth));
  }
  const gpu::RenderPipelineInfo info = picture_pipeline(look);
  WEFT_SET(made.object_draws_,
           ObjectDraws::create(device, textured ? "render/object_lit.wgsl" : "render/object.wgsl", info,
                               scene.objects));
  WEFT_SET(made.floors_, Floors::create(device, textured ? "render/floor_lit.wgsl" : "render/floor.wgsl",
                                        info, scene.planes.size()));
  WEFT_SET(made.background_, Background::create(device, look, scene.frame, scene.light));
  WEFT_CHECK(made.bind(scene));
  return made;
}

Result<void> ViewPasses::bind(const DrawnScene& scene) {
  const ObjectBuffers& objects = scene.objects;
  const gpu::BindingSource depth = scene.soft_light.depth(), arriving = scene.soft_light.arriving();
  const gpu::BindingSource map = scene.shadow_map.texture(), sampler = scene.shadow_map.sampler();
  const bool textured = view_ == scene::View::Textured;
  WEFT_CHECK(textured ? object_draws_.bind({scene.frame, scene.light, depth, arriving, objects.position,
                                            objects.normal, objects.placement})
                      : object_draws_.bind({scene.frame, map, sampler, objects.position, objects.normal,
                                            objects.placement}));
  for (std::size_t k = 0; k < scene.planes.size(); ++k)
    WEFT_CHECK(textured ? floors_.bind(k, {scene.frame, scene.light, depth, arriving, scene.planes[k]})
                        : floors_.bind(k, {scene.frame, map, sampler, scene.planes[k]}));
  if (view_ == scene::View::Wireframe) return {};
  for (std::size_t k = 0; k < scene.cloth.ranges.size(); ++k)
    for (std::size_t parity = 0; parity < 2; ++parity) {
      const gpu::RawBuffer &position = *scene.cloth.position[parity], &normal = *scene.cloth.normal;
      WEFT_CHECK(textured ? cloth_surface_.bind(k, parity,
                                                {scene.frame, scene.light, depth, arriving, scene.fabrics[k],
                                                 position, normal, *scene.cloth.uv})
                          : cloth_surface_.bind(
                                k, parity,
                                {scene.frame, position, normal, field_buffer(scene.cloth, view_, parity)}));
    }
  return {};
}

void ViewPasses::record(gpu::RenderPass& pass, std::uint32_t parity) const {
  cloth_surface_.record(pass, parity);
  cloth_wireframe_.record(pass, parity);
  object_draws_.record(pass);
  floors_.record(pass);
  background_.record(pass);
}

}  // namespace weft::render
