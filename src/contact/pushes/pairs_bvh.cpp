#include "contact/pushes/pairs_bvh.hpp"

namespace weft::contact {
namespace {

/// Two triangles a walk save loads where all lanes are busy: on software adapters always (half the time), on
/// an H100 from about half a million triangles on (0.12 instead of 0.15 ms at 1.28 M over the armadillo).
/// Below, a card has lanes to spare, and the longer walk of two costs time (0.077 instead of 0.055 ms at
/// 19,602).
std::uint32_t choose_triangles_each(const gpu::Device& device, const GpuModel& model) {
  constexpr std::uint32_t kFull = 500000;
  return device.adapter().type == "CPU" || model.triangle_count() > kFull ? 2 : 1;
}

}  // namespace

Result<PairsBvh> PairsBvh::create(gpu::Device& device, const GpuModel& model, const State& state,
                                  const Contacts& contacts, std::span<const ObjectTriangle> triangles,
                                  std::uint32_t workgroup_size, std::uint32_t triangles_each) {
  const ObjectTree tree = build_object_tree(triangles);
  if (tree.stack_size > kStackSize)
    return make_error(ErrorKind::Limit,
                      "The tree over %zu triangles needs a stack of %u, more than the kernel's %u.",
                      triangles.size(), tree.stack_size, kStackSize);
  PairsBvh bvh;
  const std::uint32_t each = triangles_each != 0 ? triangles_each : choose_triangles_each(device, model);
  bvh.invocations_ = (model.triangle_count() + each - 1) / each;
  WEFT_TRY(kernel, gpu::Kernel::create(device, "contact/pushes/bvh.wgsl",
                                       {{"kTrianglesEach", static_cast<double>(each)}}, workgroup_size));
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

}  // namespace weft::contact
