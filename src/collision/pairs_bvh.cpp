#include "collision/pairs_bvh.hpp"

namespace weft::collision {

Result<PairsBvh> PairsBvh::create(gpu::Device& device, const Model& model, const State& state,
                                  const Contacts& contacts, std::span<const ObjectTriangle> triangles,
                                  std::uint32_t workgroup_size) {
  const ObjectTree tree = build_object_tree(triangles);
  if (tree.stack_size > kStackSize)
    return make_error(ErrorKind::Limit,
                      "The tree over %zu triangles needs a stack of %u, more than the kernel's %u.",
                      triangles.size(), tree.stack_size, kStackSize);
  PairsBvh bvh;
  bvh.invocations_ = (model.triangle_count() + 1) / 2;  // two cloth triangles each
  WEFT_TRY(kernel, gpu::Kernel::create(device, "collision/bvh.wgsl", {}, workgroup_size));
  bvh.kernel_ = std::move(kernel);
  WEFT_TRY(nodes, gpu::Buffer<TreeNode>::create_from(device, tree.nodes, "tree nodes"));
  bvh.nodes_ = std::move(nodes);
  WEFT_TRY(leaf_triangles,
           gpu::Buffer<ObjectTriangle>::create_from(device, tree.triangles, "object triangles"));
  bvh.triangles_ = std::move(leaf_triangles);
  WEFT_TRY(ids, gpu::Buffer<std::uint32_t>::create_from(device, tree.ids, "object ids"));
  bvh.ids_ = std::move(ids);
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, bvh.kernel_.bind({state.steps, state.position[1 - parity], state.position[parity],
                                      model.triangles, bvh.triangles_, bvh.ids_, contacts.pushes,
                                      state.statistics, bvh.nodes_}));
    bvh.groups_[parity] = std::move(group);
  }
  return bvh;
}

void PairsBvh::record(gpu::ComputePass& pass) const {
  kernel_.dispatch(pass, groups_[pass.parity()], invocations_);
}

}  // namespace weft::collision
