#include "pictures.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "scene/motion.hpp"

namespace weft::cli {
namespace {

std::string frame_name(std::uint32_t frame) {
  char name[32];
  std::snprintf(name, sizeof name, "frame_%05u.png", frame);
  return name;
}

void include(mesh::Bounds& bounds, const Vec3f& point) {
  bounds.low = min(bounds.low, point);
  bounds.high = max(bounds.high, point);
}

render::Inputs inputs_of(const sim::World& world) {
  const Model& model = world.model();
  render::Inputs inputs;
  inputs.cloth.position = {&world.state().position[0], &world.state().position[1]};
  inputs.cloth.normal = &world.surface().normal();
  inputs.cloth.stretch = &world.surface().stretch();
  inputs.cloth.uv = &model.uv;
  inputs.cloth.triangles = &model.triangles;
  for (const ClothModel& cloth : model.host.cloths) {
    double size = 0;
    for (std::uint32_t v = 0; v < cloth.vertex_count; ++v) {
      const auto& uv = model.host.uv[cloth.first_vertex + v];
      size = std::max({size, static_cast<double>(uv[0]), static_cast<double>(uv[1])});
    }
    inputs.cloth.ranges.push_back({cloth.first_triangle, cloth.triangle_count, cloth.color, size});
  }
  inputs.objects = world.assets().objects;
  for (const scene::Collider& collider : world.scene().colliders) {
    if (const auto* sphere = std::get_if<scene::ColliderSphere>(&collider)) inputs.spheres.push_back(*sphere);
    if (const auto* plane = std::get_if<scene::ColliderPlane>(&collider)) inputs.planes.push_back(*plane);
  }
  return inputs;
}

}  // namespace

mesh::Bounds picture_bounds(const sim::World& world) {
  const HostModel& model = world.model().host;
  mesh::Bounds bounds{model.rest_position[0].to<float>(), model.rest_position[0].to<float>()};
  const double end = world.scene().time.frames * world.scene().time.frame;
  double sag = 0;  // how far a sheet can hang down from where it is held or lies [m]
  for (const auto& uv : model.uv)
    sag = std::max({sag, static_cast<double>(uv[0]), static_cast<double>(uv[1])});
  const Vec3d pull = world.scene().gravity + world.scene().external_force;
  const Vec3d down = length(pull) > 0 ? pull / length(pull) : Vec3d{};
  for (std::size_t v = 0; v < model.vertex_count(); ++v) {
    include(bounds, model.rest_position[v].to<float>());
    include(bounds, (model.rest_position[v] + sag * down).to<float>());
    if (model.motion[v] > 1)
      include(bounds,
              scene::motion_at(model.motions[model.motion[v] - 2], end)(model.rest_position[v]).to<float>());
  }
  for (const mesh::TriangleMesh& object : world.assets().objects) {
    const mesh::Bounds box = mesh::bounds(object);
    include(bounds, box.low);
    include(bounds, box.high);
  }
  for (const scene::Collider& collider : world.scene().colliders)
    if (const auto* sphere = std::get_if<scene::ColliderSphere>(&collider)) {
      const Vec3d r{sphere->radius, sphere->radius, sphere->radius};
      include(bounds, (sphere->center - r).to<float>());
      include(bounds, (sphere->center + r).to<float>());
    }
  return bounds;
}

Result<std::unique_ptr<Pictures>> Pictures::create(const sim::World& world, const std::string& folder) {
  auto made = std::make_unique<Pictures>();
  made->folder_ = folder;
  made->device_ = &world.device();
  const scene::Render& wanted = world.scene().render;
  render::Settings settings;
  settings.width = wanted.width;
  settings.height = wanted.height;
  settings.view = wanted.view;
  settings.camera = world.scene().camera;
  settings.bounds = picture_bounds(world);
  WEFT_TRY(offscreen, picture::Offscreen::create(world.device(), settings, inputs_of(world)));
  made->offscreen_ = std::move(offscreen);
  WEFT_TRY(video, picture::VideoWriter::create(folder + "/run.mp4", wanted.width, wanted.height,
                                               1 / world.scene().time.frame));
  made->video_ = std::move(video);
  return made;
}

Result<void> Pictures::draw(const sim::World& world) {
  while (offscreen_->full()) {
    WEFT_TRY(image, offscreen_->read());
    WEFT_CHECK(store(std::move(image)));
  }
  list_.reset();
  offscreen_->record(list_, world.parity());
  WEFT_CHECK(device_->submit(list_));
  offscreen_->start();
  ++drawn_;
  WEFT_TRY(arrived, offscreen_->try_take());
  if (arrived) WEFT_CHECK(store(std::move(*arrived)));
  return {};
}

Result<void> Pictures::store(picture::Image image) {
  if (video_) WEFT_CHECK(video_->add(image));
  return png_.push(folder_ + "/" + frame_name(stored_++), std::move(image));
}

Result<void> Pictures::finish() {
  while (offscreen_->pending() > 0) {
    WEFT_TRY(image, offscreen_->read());
    WEFT_CHECK(store(std::move(image)));
  }
  WEFT_CHECK(png_.finish());
  std::error_code ignored;
  if (has_video())
    WEFT_CHECK(video_->finish());
  else
    std::filesystem::remove(folder_ + "/run.mp4", ignored);
  for (std::uint32_t old = stored_; std::filesystem::remove(folder_ + "/" + frame_name(old), ignored);
       ++old) {
  }
  return {};
}

}  // namespace weft::cli
