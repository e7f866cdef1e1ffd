// What a page or a window shows of a world: the renderer on its canvas, the recorded lists and the camera.
#pragma once

#include <array>

#include "render/pick.hpp"
#include "render/present.hpp"
#include "render/renderer.hpp"
#include "sim/world.hpp"

namespace weft::view {

/// Where it draws. In a browser the target is a view that is of another texture in every frame (gpu/web/imports.hpp).
struct Canvas {
  gpu::Id target = 0;  // 0: none
  gpu::TextureFormat format = gpu::TextureFormat::Rgba8UnormSrgb;
  std::uint32_t width = 0, height = 0;  // [pixel]
};

class CanvasView {
 public:
  /// Errors  Limit, Shader, OutOfMemory.
  static Result<CanvasView> create(const sim::World& world, const Canvas& canvas, scene::View view);

  /// Draws there from now on: a view of the same format and size.
  void set_target(gpu::Id target);
  Result<void> resize(std::uint32_t width, std::uint32_t height);
  Result<void> can_show(scene::View view) const { return renderer_.can_show(view); }
  Result<void> set_view(scene::View view);
  scene::View view() const { return renderer_.view(); }
  const Canvas& canvas() const { return canvas_; }

  /// What draws the state that lies in this parity's buffers.
  const gpu::CommandList& list(std::uint32_t parity) const { return lists_[parity]; }

  /// Takes over looks, colours, materials and light of the world's scene, from the next submit of a list on.
  void set_appearance(const sim::World& world);
  /// As render::Renderer::set_time; before the submit of a list.
  void set_time(double time) { renderer_.set_time(time); }

  const render::Camera& camera() const { return renderer_.camera(); }
  void set_camera(const render::Camera& camera) { renderer_.set_camera(camera); }
  void reset_camera() { renderer_.set_camera(first_camera_); }

  render::Ray ray(double x, double y) const { return render::pick_ray(camera(), aspect(), x, y); }
  render::Projected project(const Vec3d& point) const { return render::project(camera(), aspect(), point); }
  std::vector<std::uint32_t> nodes_within(const render::PickArea& area,
                                          std::span<const Vec4f> positions) const {
    return render::nodes_within(camera(), aspect(), area, positions);
  }
  /// The point on the ray through (x, y) that is as far along the view as `reference`.
  Vec3d point_at(double x, double y, const Vec3d& reference) const;

 private:
  double aspect() const { return static_cast<double>(canvas_.width) / canvas_.height; }
  void record();

  Canvas canvas_;
  render::Renderer renderer_;
  render::Present present_;
  render::Camera first_camera_;
  std::vector<scene::Material> materials_;  // of the colliders, as they are drawn
  std::array<gpu::CommandList, 2> lists_;   // by parity
};

}  // namespace weft::view
