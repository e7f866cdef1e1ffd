#pragma once

#include <array>
#include <iterator>
#include <memory>
#include <optional>

#include "gpu/device.hpp"
#include "gpu/texture.hpp"
#include "render/camera.hpp"
#include "render/field.hpp"
#include "render/fine_cloth.hpp"
#include "render/inputs.hpp"
#include "render/light.hpp"
#include "render/moving_objects.hpp"
#include "render/view_passes.hpp"
#include "scene/names.hpp"

namespace weft::render {

using scene::View;
inline constexpr std::size_t kViewCount = std::size(scene::kViewNames);

struct Settings {
  std::uint32_t width = 1280, height = 720;  // [pixel]
  View view = View::Textured;
  gpu::TextureFormat color_format = gpu::TextureFormat::Rgba8UnormSrgb;  // of the texture drawn into
  mesh::Bounds bounds;  // of all that is drawn over the whole run [m]: light, depth and camera fit it
  std::optional<Camera> camera;   // none: frame_camera(bounds)
  std::optional<Vec3d> to_light;  // direction; none: default_light(camera)
  Lighting lighting;              // of View::Textured
  std::optional<Range> range;     // of the colour map; none: that of the view's field
  std::uint32_t subdivide = 0;    // how often each cell of the cloths, all grids then, is halved
  bool ground_shadow = false;     // a soft shadow below all, where the scene has no plane
};

/// The settings' camera, or one that has all of their bounds in the frame.
Camera camera_of(const Settings& settings);

/// Draws a state's buffers where they lie, with light and shadow, into a texture of the caller's.
class Renderer {
 public:
  /// Reads   inputs.cloth: buffers that outlive the renderer; obstacles are copied, but for Inputs::colliders.
  /// Errors  Shape: buffers disagree in size, the view lacks one, or what is subdivided is not a grid. Limit:
  /// the
  ///         picture or the subdivided cloth is larger than the adapter can make. OutOfMemory.
  static Result<Renderer> create(gpu::Device& device, const Settings& settings, const Inputs& inputs);

  /// Records all passes. `parity` chooses the position buffer; `target` is the view of a texture of the size
  /// and the color_format of the settings, with one sample a pixel. The list serves until the size or the
  /// view changes.
  void record(gpu::CommandList& list, std::uint32_t parity, gpu::Id target) const;

  /// Another size of the texture drawn into [pixel]; the camera keeps its place and vertical field of view.
  /// Errors  Input: a side is 0. Limit, OutOfMemory. After an error the size is as it was.
  Result<void> resize(std::uint32_t width, std::uint32_t height);
  /// Whether there is something to show in a view. Errors  Input: what it shows is no part of the scene.
  /// Shape: the inputs lack it.
  Result<void> can_show(View view) const;
  /// The view of the picture. The pipelines of a view are made on first use, and kept.
  /// Errors  Shape: the inputs lack what the view shows. Shader. After an error the view is as it was.
  Result<void> set_view(View view);
  View view() const { return settings_.view; }
  // What the textured view is drawn with, from the next submit on.

  /// The looks and colours of the cloths of `inputs`, which are otherwise those that it was created with.
  void set_looks(const Inputs& inputs);
  /// The materials of its obstacles, which are otherwise those; set_time before the next submit.
  void set_materials(const Inputs& inputs);
  /// The sun and what is around; without a direction to it, from where it would shine if the renderer were new.
  void set_light(const Lighting& lighting, const std::optional<Vec3d>& to_light);

  /// Moves the camera, from the next submit on; the light stays.
  void set_camera(const Camera& camera);
  /// Brings the obstacles that move or deform to where they are at `time` [s], from the next submit on. Costs
  /// nothing where none does.
  void set_time(double time);
  const Camera& camera() const { return *settings_.camera; }

 private:
  struct MovingPlane {
    std::size_t plane = 0;  // of DrawnScene::planes
    PlaneParams rest;
    scene::ColliderMotion motion;
    std::optional<std::size_t> given{};  // as ObjectDraw::given
  };

  Result<void> create_scene(const Inputs& inputs);
  LightParams light() const;
  void take_planes(const Inputs& inputs, const std::vector<PlaneParams>& squares);
  void write_frame();
  /// Whether anything drawn takes shadows: cloth does in one view only, obstacles and floors in all.
  bool shows_sun() const;

  gpu::Device* device_ = nullptr;
  Settings settings_;
  Camera first_camera_;  // which the light is put around
  gpu::Texture color_, depth_;
  ClothDraw given_;                  // as the state has it
  std::unique_ptr<FineCloth> fine_;  // none: what is given is drawn
  DrawnScene scene_;
  const std::vector<scene::Collider>* colliders_ = nullptr;  // Inputs::colliders
  MovingObjects moving_objects_;
  RigidRows rigid_;
  std::vector<std::array<std::size_t, 2>>
      rigid_objects_;  // of the moving ones: its number, and its collider's
  std::vector<MovingPlane> moving_planes_;
  std::array<std::optional<ViewPasses>, kViewCount> passes_;  // by view
};

}  // namespace weft::render
