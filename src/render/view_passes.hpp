#pragma once

#include <vector>

#include "render/background.hpp"
#include "render/cloth_surface.hpp"
#include "render/cloth_wireframe.hpp"
#include "render/fabric.hpp"
#include "render/floor.hpp"
#include "render/object_draws.hpp"
#include "render/soft_light.hpp"

namespace weft::render {

/// The inputs that the passes of all views share.
struct DrawnScene {
  gpu::Buffer<FrameParams> frame;
  gpu::Buffer<LightParams> light;
  ClothDraw cloth;
  std::vector<gpu::Buffer<FabricParams>> fabrics;  // one a cloth
  std::vector<gpu::Buffer<PlaneParams>> planes;
  ObjectBuffers objects;
  ShadowMap shadow_map;
  SoftLight soft_light;  // of the textured view
};

/// All that one view draws into the picture: pipelines and bind groups, no buffers.
class ViewPasses {
 public:
  /// Errors  Shader.
  static Result<ViewPasses> create(gpu::Device& device, const Look& look, const DrawnScene& scene);
  /// What depends on the picture's size is bound again. Errors  OutOfMemory.
  Result<void> bind(const DrawnScene& scene);
  void record(gpu::RenderPass& pass, std::uint32_t parity) const;

 private:
  scene::View view_{};
  ClothSurface cloth_surface_;  // of these two, one is empty
  ClothWireframe cloth_wireframe_;
  ObjectDraws object_draws_;
  Floors floors_;
  Background background_;
};

}  // namespace weft::render
