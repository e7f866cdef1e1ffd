#include "method/multigrid/mesh_cycle.hpp"

#include "method/multigrid/cloth_nodes.hpp"
#include "method/multigrid/kernel_set.hpp"
#include "method/multigrid/uniform.hpp"

namespace weft {

Result<MeshCycle> MeshCycle::create(gpu::Device& device, const MeshKernels& kernels, const Model& model,
                                    const State& state, const Predicted& predicted,
                                    const gpu::Buffer<std::int32_t>* presses, const ClothModel& cloth) {
  MeshCycle made;
  const std::vector<Spring> springs = build_springs(model.host, cloth);
  const MeshLists lists = mesh_lists(mesh_levels(model.host, cloth, springs));
  made.levels_ = lists.levels;
  made.tail_ = 1;
  while (made.tail_ + 1 < made.levels_.size() &&  // the last one is of the tail, however large
         made.levels_[made.tail_].node_count > multigrid::kMeshTailNodes)
    ++made.tail_;
  WEFT_CHECK(made.create_lists(device, lists, springs));
  WEFT_CHECK(made.create_buffers(device, lists, cloth, presses != nullptr));
  WEFT_CHECK(made.create_ends(kernels, model, state, predicted, presses));
  WEFT_CHECK(made.create_steps(kernels));
  return made;
}

Result<void> MeshCycle::create_lists(gpu::Device& device, const MeshLists& lists,
                                     const std::vector<Spring>& springs) {
  const auto make = [&](auto& buffer, const auto& values, const char* label) -> Result<void> {
    using Made = std::remove_reference_t<decltype(buffer)>;
    WEFT_TRY(made, Made::create_from(device, values, label));
    buffer = std::move(made);
    return {};
  };
  std::vector<Vec4f> of_blocks;
  of_blocks.reserve(springs.size());
  for (const Spring& s : springs) of_blocks.push_back({s.rest_length, s.stiffness, s.damping, 0});
  WEFT_CHECK(make(lists_.row_starts, lists.row_starts, "multigrid row starts"));
  WEFT_CHECK(make(lists_.rows, lists.rows, "multigrid rows"));
  WEFT_CHECK(make(lists_.source_starts, lists.source_starts, "multigrid source starts"));
  WEFT_CHECK(make(lists_.sources, lists.sources, "multigrid sources"));
  WEFT_CHECK(make(lists_.product_starts, lists.product_starts, "multigrid product starts"));
  WEFT_CHECK(make(lists_.products, lists.products, "multigrid products"));
  WEFT_CHECK(make(lists_.taps, lists.taps, "multigrid taps"));
  return make(lists_.springs, of_blocks, "multigrid springs");
}

Result<void> MeshCycle::create_buffers(gpu::Device& device, const MeshLists& lists, const ClothModel& cloth,
                                       bool holds) {
  WEFT_TRY(nodes, uniform(device, ClothNodes{cloth.first_vertex, cloth.vertex_count}, "cloth nodes"));
  nodes_ = std::move(nodes);
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    std::array<MultigridMeshLevel, 2> pair = {levels_[l]};
    if (l + 1 < levels_.size()) pair[1] = levels_[l + 1];
    WEFT_TRY(levels, uniform(device, pair, "multigrid levels"));
    Step step;
    step.levels = std::move(levels);
    steps_.push_back(std::move(step));
  }
  WEFT_TRY(tail, gpu::Buffer<MultigridMeshLevel>::create_from(device, std::span(levels_).subspan(tail_),
                                                              "coarsest multigrid levels"));
  tail_levels_ = std::move(tail);
  WEFT_TRY(place, gpu::Buffer<Vec4f>::create(device, levels_[0].node_count, "multigrid place"));
  place_ = std::move(place);
  // One element each where nothing holds: kernels bind what they do not read.
  WEFT_TRY(hold_buffer,
           gpu::Buffer<Vec4f>::create(device, holds ? levels_[0].node_count : 1, "multigrid holds"));
  holds_ = std::move(hold_buffer);
  WEFT_TRY(none, gpu::Buffer<std::int32_t>::create(device, 1, "no presses"));
  no_presses_ = std::move(none);
  WEFT_TRY(vectors, gpu::Buffer<Vec4f>::create(device, lists.vector_count, "multigrid vectors"));
  vectors_ = std::move(vectors);
  WEFT_TRY(blocks, gpu::Buffer<Vec4f>::create(device, 2 * lists.block_count, "multigrid blocks"));
  blocks_ = std::move(blocks);
  return {};
}

Result<void> MeshCycle::create_ends(const MeshKernels& kernels, const Model& model, const State& state,
                                    const Predicted& predicted, const gpu::Buffer<std::int32_t>* presses) {
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(predict,
             kernels.predict.bind({state.steps, nodes_, state.position[parity], state.velocity[parity],
                                   state.position[1 - parity], state.velocity[1 - parity],
                                   model.rest_position, state.motions, place_, vectors_}));
    predict_[parity] = std::move(predict);
    WEFT_TRY(finish,
             kernels.finish.bind({state.steps, nodes_, place_, holds_, vectors_, state.position[parity],
                                  state.velocity[parity], state.position[1 - parity], *predicted[parity]}));
    finish_[parity] = std::move(finish);
  }
  WEFT_TRY(gradient, kernels.gradient.bind({state.steps, nodes_, steps_[0].levels, place_, holds_, vectors_,
                                            blocks_, lists_.row_starts, lists_.rows, lists_.springs,
                                            presses != nullptr ? *presses : no_presses_}));
  gradient_ = std::move(gradient);
  return {};
}

Result<void> MeshCycle::create_steps(const MeshKernels& kernels) {
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    Step& step = steps_[l];
    WEFT_TRY(galerkin,
             kernels.galerkin.bind({step.levels, vectors_, blocks_, lists_.product_starts, lists_.products}));
    step.galerkin = std::move(galerkin);
    if (l >= tail_) continue;
    WEFT_TRY(restriction,
             kernels.restrict_residual.bind({step.levels, vectors_, lists_.source_starts, lists_.sources}));
    step.restrict_residual = std::move(restriction);
    WEFT_TRY(prolong, kernels.prolong.bind({step.levels, vectors_, lists_.taps}));
    step.prolong = std::move(prolong);
    WEFT_CHECK(bind_each({{step.smooth_down, kernels.smooth_down},
                          {step.residual, kernels.residual},
                          {step.smooth_begin, kernels.smooth_begin},
                          {step.smooth_up, kernels.smooth_up}},
                         {step.levels, vectors_, blocks_, lists_.row_starts, lists_.rows}));
  }
  WEFT_TRY(tail, kernels.tail.bind({tail_levels_, vectors_, blocks_, lists_.row_starts, lists_.rows,
                                    lists_.source_starts, lists_.sources, lists_.taps}));
  cycle_tail_ = std::move(tail);
  return {};
}

void MeshCycle::record_system(gpu::ComputePass& pass, const MeshKernels& kernels) const {
  kernels.predict.dispatch(pass, predict_[pass.parity()], levels_[0].node_count);
  kernels.gradient.dispatch(pass, gradient_, levels_[0].node_count);
}

void MeshCycle::record_matrices(gpu::ComputePass& pass, const MeshKernels& kernels) const {
  for (std::size_t l = 0; l + 1 < levels_.size(); ++l)
    kernels.galerkin.dispatch(pass, steps_[l].galerkin, levels_[l + 1].block_count);
}

void MeshCycle::record_down(gpu::ComputePass& pass, const MeshKernels& kernels) const {
  for (std::size_t l = 0; l < tail_; ++l) {
    kernels.smooth_down.dispatch(pass, steps_[l].smooth_down, levels_[l].node_count);
    if (l + 1 == levels_.size()) return;  // the only one
    kernels.residual.dispatch(pass, steps_[l].residual, levels_[l].node_count);
    kernels.restrict_residual.dispatch(pass, steps_[l].restrict_residual, levels_[l + 1].node_count);
  }
  kernels.tail.dispatch_groups(pass, cycle_tail_, 1);
}

void MeshCycle::record_up(gpu::ComputePass& pass, const MeshKernels& kernels) const {
  for (std::size_t l = tail_; l-- > 0;) {
    kernels.prolong.dispatch(pass, steps_[l].prolong, levels_[l].node_count);
    kernels.smooth_begin.dispatch(pass, steps_[l].smooth_begin, levels_[l].node_count);
    kernels.smooth_up.dispatch(pass, steps_[l].smooth_up, levels_[l].node_count);
  }
  kernels.finish.dispatch(pass, finish_[pass.parity()], levels_[0].node_count);
}

void MeshCycle::record(gpu::ComputePass& pass, const MeshKernels& kernels) const {
  record_system(pass, kernels);
  record_matrices(pass, kernels);
  record_down(pass, kernels);
  record_up(pass, kernels);
}

}  // namespace weft
