#include "view/canvas_view.hpp"

#include "view/world_inputs.hpp"

namespace weft::view {
namespace {

std::vector<scene::Material> materials_of(const scene::Scene& scene) {
  std::vector<scene::Material> materials;
  for (const scene::Collider& collider : scene.colliders) materials.push_back(scene::material_of(collider));
  return materials;
}

}  // namespace

Result<CanvasView> CanvasView::create(const sim::World& world, const Canvas& canvas, scene::View view) {
  CanvasView made;
  made.canvas_ = canvas;
  render::Settings settings = settings_of(world);
  settings.width = canvas.width;
  settings.height = canvas.height;
  settings.view = view;
  settings.color_format = render::srgb_format(canvas.format);
  WEFT_TRY(renderer, render::Renderer::create(world.device(), settings, inputs_of(world)));
  made.renderer_ = std::move(renderer);
  WEFT_TRY(present, render::Present::create(world.device(), canvas.format, canvas.width, canvas.height));
  made.present_ = std::move(present);
  made.first_camera_ = made.renderer_.camera();
  made.materials_ = materials_of(world.scene());
  made.record();
  return made;
}

void CanvasView::record() {
  for (std::uint32_t parity = 0; parity < 2; ++parity) {
    lists_[parity].reset();
    renderer_.record(lists_[parity], parity, present_.picture());
    present_.record(lists_[parity], canvas_.target);
  }
}

void CanvasView::set_target(gpu::Id target) {
  canvas_.target = target;
  record();
}

Result<void> CanvasView::resize(std::uint32_t width, std::uint32_t height) {
  WEFT_CHECK(renderer_.resize(width, height));
  WEFT_CHECK(present_.resize(width, height));
  canvas_.width = width;
  canvas_.height = height;
  record();
  return {};
}

Result<void> CanvasView::set_view(scene::View view) {
  WEFT_CHECK(renderer_.set_view(view));
  record();
  return {};
}

void CanvasView::set_appearance(const sim::World& world) {
  const render::Inputs inputs = inputs_of(world);
  renderer_.set_looks(inputs);
  const scene::Light& light = world.scene().render.light;
  renderer_.set_light({light.environment, light.degrees}, light.direction);
  // All vertices of obstacles are made again, which a slider of the light need not wait for.
  std::vector<scene::Material> materials = materials_of(world.scene());
  if (materials == materials_) return;
  renderer_.set_materials(inputs);
  materials_ = std::move(materials);
}

Vec3d CanvasView::point_at(double x, double y, const Vec3d& reference) const {
  const render::Ray towards = ray(x, y);
  const Vec3d forward = camera().target - camera().eye;
  const double depth = dot(reference - towards.origin, forward) / dot(towards.direction, forward);
  return towards.origin + depth * towards.direction;
}

}  // namespace weft::view
