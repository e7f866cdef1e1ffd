#pragma once

#include <optional>
#include <vector>

#include "gpu/device.hpp"
#include "gpu/texture.hpp"
#include "render/background.hpp"
#include "render/camera.hpp"
#include "render/cloth_surface.hpp"
#include "render/cloth_wireframe.hpp"
#include "render/floor.hpp"
#include "render/inputs.hpp"
#include "render/object_surface.hpp"
#include "render/picture_pipeline.hpp"
#include "render/shadow_map.hpp"

namespace weft::render {

using scene::View;

struct Settings {
  std::uint32_t width = 1280, height = 720;  // [pixel]
  View view = View::Textured;
  mesh::Bounds bounds;  // of all that is drawn over the whole run [m]: light, depth and camera fit it
  std::optional<Camera> camera;                          // none: frame_camera(bounds)
  std::optional<Vec3d> to_light;                         // direction; none: default_light(camera)
  double lowest_stretch = 0.95, highest_stretch = 1.15;  // the ends of the colour map
  bool ground_shadow = false;  // a soft shadow below all, where the scene has no plane
};

/// Draws a state's buffers where they lie, with light and shadow, into a texture of the caller's.
class Renderer {
 public:
  /// Reads   inputs.cloth: buffers that outlive the renderer; inputs.objects are copied.
  /// Errors  Shape: buffers disagree in size, or the view lacks one. Limit: the picture is larger than the
  ///         adapter can make. OutOfMemory.
  static Result<Renderer> create(gpu::Device& device, const Settings& settings, const Inputs& inputs);

  /// Records all passes. `parity` chooses the position buffer; `target` is the view of a texture of the
  /// settings' size and of kColorFormat, with one sample a pixel.
  void record(gpu::CommandList& list, std::uint32_t parity, gpu::Id target) const;

  /// Moves the camera, from the next submit on; the light stays.
  void set_camera(const Camera& camera);
  const Camera& camera() const { return *settings_.camera; }

 private:
  Result<void> create_targets();
  void write_frame();

  gpu::Device* device_ = nullptr;
  Settings settings_;
  gpu::Buffer<FrameParams> frame_;
  gpu::Texture color_, depth_;
  ObjectBuffers objects_;
  ShadowMap shadow_map_;
  ObjectSurface object_surface_;
  ClothSurface cloth_surface_;
  ClothWireframe cloth_wireframe_;
  std::vector<Floor> floors_;
  Background background_;
};

}  // namespace weft::render
