#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "gpu/kernel.hpp"
#include "render/inputs.hpp"
#include "scene/names.hpp"

namespace weft::render {

/// Mirror of FineGrid in src/render/fine_grid.wgsl.
struct FineGridParams {
  std::uint32_t first_node = 0, first_vertex = 0, nx = 0, ny = 0, level = 0;
  std::array<std::uint32_t, 3> padding{};  // to a multiple of 16 bytes
};

/// All cloths drawn finer than they are simulated: a cubic surface through their nodes
/// (mesh/subdivided_grid.hpp), found anew for each picture where the state lies. Reads   the buffers of a
/// ClothDraw whose cloths are grids. Writes  buffers of its own of the same kinds: draw() names them, for
/// both parities the same.
class FineCloth {
 public:
  /// `level` from 1 on: how often each cell is halved. The buffers of `coarse` must outlive this.
  /// Errors  Limit: the finer mesh does not fit this adapter's buffers, found before anything is made. Shape:
  /// a
  ///         cloth is not a grid. OutOfMemory, Shader.
  static Result<std::unique_ptr<FineCloth>> create(gpu::Device& device, const ClothDraw& coarse,
                                                   std::uint32_t level);
  /// Makes what `view` shows of each vertex, if it shows a field and `coarse` has it.
  /// Errors  Limit, OutOfMemory, Shader.
  Result<void> add_field(gpu::Device& device, scene::View view);

  const ClothDraw& draw() const { return draw_; }
  /// Brings the state in the buffers of this parity to those of draw(), and what the view shows of it.
  void record(gpu::CommandList& list, std::uint32_t parity, scene::View view) const;

 private:
  struct Part {
    gpu::Buffer<FineGridParams> params;
    std::array<gpu::BindGroup, 2> groups;  // by parity
    std::uint64_t vertex_count = 0;
  };
  /// A view: its kernel, and its inputs for each cloth and parity.
  struct Field {
    gpu::Kernel kernel;
    gpu::RawBuffer values;
    std::vector<std::array<gpu::BindGroup, 2>> groups;
  };

  Result<void> create_vertices(gpu::Device& device, std::uint32_t level);
  Result<void> create_parts(gpu::Device& device, std::uint32_t level);

  ClothDraw coarse_, draw_;
  gpu::Kernel kernel_;
  gpu::Buffer<Vec4f> position_, normal_;
  gpu::Buffer<std::array<float, 2>> uv_;
  gpu::Buffer<std::uint32_t> triangles_;
  std::vector<Part> parts_;
  std::array<std::optional<Field>, std::size(scene::kViewNames)> fields_;  // by view
};

}  // namespace weft::render
