#include "bench/drawn_frames.hpp"

#include <array>

#include "gpu/texture.hpp"
#include "render/renderer.hpp"
#include "view/world_inputs.hpp"

namespace weft::bench {
namespace {

/// A renderer, the texture it draws into, and its commands for each parity of the state.
struct Drawing {
  render::Renderer renderer;
  gpu::Texture target;
  std::array<gpu::CommandList, 2> lists;
};

Result<Drawing> make_drawing(const sim::World& world) {
  render::Settings settings = view::settings_of(world);
  settings.width = 1280;
  settings.height = 720;
  settings.view = scene::View::Textured;
  Drawing made;
  WEFT_TRY(renderer, render::Renderer::create(world.device(), settings, view::inputs_of(world)));
  made.renderer = std::move(renderer);
  WEFT_TRY(target, gpu::Texture::create(
                       world.device(),
                       {settings.width, settings.height, 1, settings.color_format, gpu::kRenderTarget},
                       "drawn frame"));
  made.target = std::move(target);
  for (std::uint32_t parity = 0; parity < 2; ++parity)
    made.renderer.record(made.lists[parity], parity, made.target.view());
  return made;
}

}  // namespace

Result<Timing> time_drawn_frames(gpu::Device& device, scene::Scene scene, const Assets& assets,
                                 const Pose* pose, double budget_ms, std::uint32_t least) {
  scene.time.frame /= *scene.time.substeps;
  scene.time.substeps = 1;
  WEFT_TRY(world, sim::World::create(device, std::move(scene), assets));
  if (pose != nullptr) WEFT_CHECK(begin_at(*pose, *world));
  WEFT_TRY(drawing, make_drawing(*world));
  const auto draw_frame = [&]() -> Result<void> {
    drawing.renderer.set_time(world->time());
    WEFT_CHECK(world->advance_frame(&drawing.lists[world->parity_after()]));
    return world->finish();
  };
  WEFT_CHECK(draw_frame());  // lists that are too short at first are longer after it
  return time_repeats(budget_ms, least, 1, draw_frame,
                      [&] { return pose != nullptr ? stay_near(*pose, *world) : Result<void>(); });
}

}  // namespace weft::bench
