#pragma once

#include <vector>

#include "render/background.hpp"
#include "render/cloth_surface.hpp"
#include "render/cloth_wireframe.hpp"
#include "render/floor.hpp"
#include "render/object_draws.hpp"

namespace weft::render {

/// The inputs that the passes of all views share.
struct DrawnScene {
  gpu::Buffer<FrameParams> frame;
  ClothDraw cloth;
  std::vector<gpu::Buffer<WeaveParams>> weaves;  // one a cloth
  std::vector<gpu::Buffer<PlaneParams>> planes;
  ObjectBuffers objects;
  ShadowMap shadow_map;
};

/// All that one view draws into the picture: pipelines and bind groups, no buffers.
class ViewPasses {
 public:
  /// Errors  Shader.
  static Result<ViewPasses> create(gpu::Device& device, const Look& look, const DrawnScene& scene);
  void record(gpu::RenderPass& pass, std::uint32_t parity) const;

 private:
  ClothSurface cloth_surface_;  // of these two, one is empty
  ClothWireframe cloth_wireframe_;
  ObjectDraws object_draws_;
  Floors floors_;
  Background background_;
};

}  // namespace weft::render
