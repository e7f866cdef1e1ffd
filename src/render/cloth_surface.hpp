#pragma once

#include <array>
#include <initializer_list>
#include <span>
#include <vector>

#include "gpu/render_pipeline.hpp"
#include "render/inputs.hpp"
#include "render/picture_pipeline.hpp"

namespace weft::render {

/// The view's value at each vertex; arbitrary where it shows no field.
const gpu::RawBuffer& field_buffer(const ClothDraw& cloth, scene::View view, std::size_t parity);

/// Draws the triangles of all cloths, as fabric, or coloured by normal or by a field.
class ClothSurface {
 public:
  ClothSurface() = default;
  static Result<ClothSurface> create(gpu::Device& device, const Look& look, const ClothDraw& cloth);
  /// The inputs of a cloth for a parity, as the shader's bindings are numbered.
  Result<void> bind(std::size_t cloth, std::size_t parity, std::initializer_list<gpu::Binding> sources);
  void record(gpu::RenderPass& pass, std::uint32_t parity) const;

 private:
  struct Part {
    std::array<gpu::BindGroup, 2> groups;  // by parity
    std::uint32_t first_index = 0, index_count = 0;
  };
  gpu::RenderPipeline pipeline_;
  std::vector<Part> parts_;
  gpu::Id index_buffer_ = 0;
};

}  // namespace weft::render
