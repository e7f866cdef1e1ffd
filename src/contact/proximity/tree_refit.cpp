#include "contact/proximity/tree_refit.hpp"

namespace weft::contact {

Result<TreeRefit> TreeRefit::create(gpu::Device& device, std::uint32_t workgroup_size) {
  TreeRefit made;
  WEFT_TRY(leaf_boxes, gpu::Kernel::create(device, "contact/proximity/leaf_boxes.wgsl", {}, workgroup_size));
  made.leaf_boxes_ = std::move(leaf_boxes);
  WEFT_TRY(upper_boxes, gpu::Kernel::create(device, "contact/proximity/upper_boxes.wgsl"));
  made.upper_boxes_ = std::move(upper_boxes);
  return made;
}

Result<void> TreeRefit::add(gpu::Device& device, const gpu::Buffer<StepBlock>& steps,
                            const ImplicitTree& tree, std::uint32_t first_triangle,
                            std::uint32_t triangle_count, const gpu::RawBuffer& positions,
                            const gpu::Buffer<TreeWord>& triangles,
                            const gpu::Buffer<std::uint32_t>& statistics,
                            const gpu::Buffer<TreeWord>& trees) {
  Part part;
  part.leaf_count = tree.leaf_count();
  part.top = tree.top();
  const TreeParams params{tree.first, tree.top(), first_triangle, triangle_count};
  WEFT_TRY(buffer, gpu::create_uniform(device, params, "tree params"));
  WEFT_TRY(leaves, leaf_boxes_.bind({steps, buffer, positions, triangles, statistics, trees}));
  part.leaves = std::move(leaves);
  WEFT_TRY(upper, upper_boxes_.bind({buffer, statistics, trees}));
  part.upper = std::move(upper);
  part.params = std::move(buffer);
  parts_.push_back(std::move(part));
  return {};
}

void TreeRefit::record(gpu::ComputePass& pass) const {
  for (const Part& part : parts_) {
    leaf_boxes_.dispatch(pass, part.leaves, part.leaf_count);
    if (part.top > 2) upper_boxes_.dispatch_groups(pass, part.upper, {1});
  }
}

}  // namespace weft::contact
