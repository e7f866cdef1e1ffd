#pragma once

#include <array>
#include <cstdint>

#include "contact/proximity/implicit_tree.hpp"
#include "gpu/kernel.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// Mirror of src/contact/proximity/tree_params.wgsl.
struct TreeParams {
  std::uint32_t tree = 0, top = 0, first_triangle = 0, triangle_count = 0;
};

/// The boxes of implicit trees, from where their triangles are. In two dispatches a tree.
/// Reads   positions [m]; triangles: corners; state.statistics: whether a detection is due.
/// Writes  trees.
/// Errors  Shader, OutOfMemory.
class TreeRefit {
 public:
  TreeRefit() = default;
  static Result<TreeRefit> create(gpu::Device& device, std::uint32_t workgroup_size);
  /// Adds a tree.
  Result<void> add(gpu::Device& device, const gpu::Buffer<StepBlock>& steps, const ImplicitTree& tree,
                   std::uint32_t first_triangle, std::uint32_t triangle_count,
                   const gpu::RawBuffer& positions, const gpu::Buffer<TreeWord>& triangles,
                   const gpu::Buffer<std::uint32_t>& statistics, const gpu::Buffer<TreeWord>& trees);
  void record(gpu::ComputePass& pass) const;

 private:
  struct Part {
    gpu::RawBuffer params;
    gpu::BindGroup leaves;
    gpu::BindGroup upper;
    std::uint32_t leaf_count = 0, top = 0;
  };
  gpu::Kernel leaf_boxes_, upper_boxes_;
  std::vector<Part> parts_;
};

}  // namespace weft::contact
