#include "render/view_passes.hpp"

namespace weft::render {

Result<ViewPasses> ViewPasses::create(gpu::Device& device, const Look& look, const DrawnScene& scene) {
  ViewPasses made;
  if (look.view == scene::View::Wireframe) {
    WEFT_TRY(cloth, ClothWireframe::create(device, look, scene.frame, scene.weaves, scene.cloth));
    made.cloth_wireframe_ = std::move(cloth);
  } else {
    WEFT_TRY(cloth,
             ClothSurface::create(device, look, scene.frame, scene.shadow_map, scene.weaves, scene.cloth));
    made.cloth_surface_ = std::move(cloth);
  }
  WEFT_TRY(objects,
           ObjectDraws::create(device, "render/object.wgsl", picture_pipeline(look), scene.objects,
                               {scene.frame, scene.shadow_map.texture(), scene.shadow_map.sampler(),
                                scene.objects.position, scene.objects.normal, scene.objects.placement}));
  made.object_draws_ = std::move(objects);
  WEFT_TRY(floors, Floors::create(device, look, scene.frame, scene.shadow_map, scene.planes));
  made.floors_ = std::move(floors);
  WEFT_TRY(background, Background::create(device, look, scene.frame));
  made.background_ = std::move(background);
  return made;
}

void ViewPasses::record(gpu::RenderPass& pass, std::uint32_t parity) const {
  cloth_surface_.record(pass, parity);
  cloth_wireframe_.record(pass, parity);
  object_draws_.record(pass);
  floors_.record(pass);
  background_.record(pass);
}

}  // namespace weft::render
