#include "method/multigrid/grid_cycle.hpp"

#include <algorithm>

#include "method/multigrid/cloth_nodes.hpp"
#include "method/multigrid/kernel_set.hpp"
#include "method/multigrid/uniform.hpp"

namespace weft {

Result<GridCycle> GridCycle::create(gpu::Device& device, const MultigridKernels& kernels, const Model& model,
                                    const State& state, const Predicted& predicted,
                                    const gpu::Buffer<std::int32_t>* presses, const ClothModel& cloth) {
  GridCycle made;
  made.levels_ = multigrid_levels(cloth);
  made.tail_ = 1;
  while (made.tail_ < made.levels_.size() && made.levels_[made.tail_].node_count() > multigrid::kTailNodes)
    ++made.tail_;
  WEFT_CHECK(made.create_buffers(device, cloth, presses != nullptr));
  WEFT_CHECK(made.create_fine(kernels, model, state, predicted, presses));
  WEFT_CHECK(made.create_coarse(kernels));
  return made;
}

Result<void> GridCycle::create_buffers(gpu::Device& device, const ClothModel& cloth, bool holds) {
  WEFT_TRY(grid, uniform(device, spring_grid(cloth), "spring grid"));
  grid_ = std::move(grid);
  WEFT_TRY(nodes, uniform(device, ClothNodes{cloth.first_vertex, cloth.vertex_count}, "cloth nodes"));
  nodes_ = std::move(nodes);
  std::size_t vectors = 0, operators = 0;
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    const std::size_t count = levels_[l].node_count();
    vectors += multigrid::kVectors * count;
    if (l > 0) operators += multigrid::kOperatorParts * count;
    if (l > 0 && l + 1 == levels_.size()) continue;
    Own own;
    own.count = levels_[l].node_count();
    std::array<MultigridLevel, 2> pair = {levels_[l]};
    if (l + 1 < levels_.size()) pair[1] = levels_[l + 1];
    own.coarse_count = pair[1].node_count();
    WEFT_TRY(levels, uniform(device, pair, "multigrid levels"));
    own.levels = std::move(levels);
    own_.push_back(std::move(own));
  }
  WEFT_TRY(tail, gpu::Buffer<MultigridLevel>::create_from(device, std::span(levels_).subspan(tail_),
                                                          "coarsest multigrid levels"));
  tail_levels_ = std::move(tail);
  WEFT_TRY(place, gpu::Buffer<Vec4f>::create(device, levels_[0].node_count(), "multigrid place"));
  place_ = std::move(place);
  // One element each where nothing holds: kernels bind what they do not read.
  WEFT_TRY(hold_buffer,
           gpu::Buffer<Vec4f>::create(device, holds ? levels_[0].node_count() : 1, "multigrid holds"));
  holds_ = std::move(hold_buffer);
  WEFT_TRY(none, gpu::Buffer<std::int32_t>::create(device, 1, "no presses"));
  no_presses_ = std::move(none);
  WEFT_TRY(vector_buffer, gpu::Buffer<Vec4f>::create(device, vectors, "multigrid vectors"));
  vectors_ = std::move(vector_buffer);
  WEFT_TRY(operator_buffer,
           gpu::Buffer<multigrid::BlockPart>::create(device, operators, "multigrid operators"));
  operators_ = std::move(operator_buffer);
  return {};
}

Result<void> GridCycle::create_fine(const MultigridKernels& kernels, const Model& model, const State& state,
                                    const Predicted& predicted, const gpu::Buffer<std::int32_t>* presses) {
  const gpu::RawBuffer& levels = own_[0].levels;
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(predict,
             kernels.predict.bind({state.steps, nodes_, state.position[parity], state.velocity[parity],
                                   state.position[1 - parity], state.velocity[1 - parity],
                                   model.rest_position, state.motions, place_, vectors_}));
    predict_[parity] = std::move(predict);
    WEFT_TRY(finish, kernels.finish.bind({state.steps, nodes_, grid_, levels, place_, holds_, vectors_,
                                          state.position[parity], state.velocity[parity],
                                          state.position[1 - parity], *predicted[parity]}));
    finish_[parity] = std::move(finish);
  }
  WEFT_CHECK(bind_each({{smooth_fine_, kernels.smooth_fine},
                        {residual_fine_, kernels.residual_fine},
                        {prolong_fine_, kernels.prolong_fine}},
                       {state.steps, grid_, levels, place_, holds_, vectors_}));
  WEFT_TRY(gradient, kernels.gradient.bind({state.steps, grid_, levels, place_, holds_, vectors_,
                                            presses != nullptr ? *presses : no_presses_}));
  gradient_ = std::move(gradient);
  WEFT_TRY(galerkin,
           kernels.galerkin_fine.bind({state.steps, grid_, levels, place_, holds_, vectors_, operators_}));
  galerkin_fine_ = std::move(galerkin);
  WEFT_TRY(correct, kernels.correct_fine.bind({levels, place_, vectors_}));
  correct_fine_ = std::move(correct);
  return {};
}

Result<void> GridCycle::create_coarse(const MultigridKernels& kernels) {
  for (std::size_t l = 0; l < own_.size(); ++l) {
    Own& own = own_[l];
    WEFT_TRY(galerkin, kernels.galerkin.bind({own.levels, vectors_, operators_}));
    own.galerkin = std::move(galerkin);
    if (l >= tail_) continue;
    WEFT_TRY(restriction, kernels.restrict_residual.bind({own.levels, vectors_}));
    own.restrict_residual = std::move(restriction);
    WEFT_CHECK(bind_each({{own.smooth_down, kernels.smooth_down},
                          {own.residual, kernels.residual},
                          {own.prolong, kernels.prolong},
                          {own.smooth_up, kernels.smooth_up}},
                         {own.levels, vectors_, operators_}));
  }
  WEFT_TRY(cycle, kernels.cycle_tail.bind({tail_levels_, vectors_, operators_}));
  cycle_tail_ = std::move(cycle);
  return {};
}

void GridCycle::record_system(gpu::ComputePass& pass, const MultigridKernels& kernels) const {
  kernels.predict.dispatch(pass, predict_[pass.parity()], levels_[0].node_count());
  kernels.gradient.dispatch(pass, gradient_, levels_[0].node_count());
}

void GridCycle::record_matrices(gpu::ComputePass& pass, const MultigridKernels& kernels) const {
  if (levels_.size() == 1) return;
  kernels.galerkin_fine.dispatch(pass, galerkin_fine_, own_[0].coarse_count);
  for (std::size_t l = 1; l < own_.size(); ++l)
    kernels.galerkin.dispatch(pass, own_[l].galerkin, multigrid::kBlocks * own_[l].coarse_count);
}

void GridCycle::record_down(gpu::ComputePass& pass, const MultigridKernels& kernels) const {
  kernels.smooth_fine.dispatch(pass, smooth_fine_, own_[0].count);
  if (levels_.size() == 1) return;
  kernels.residual_fine.dispatch(pass, residual_fine_, own_[0].count);
  kernels.restrict_residual.dispatch(pass, own_[0].restrict_residual, own_[0].coarse_count);
  for (std::size_t l = 1; l < tail_; ++l) {
    const Own& own = own_[l];
    kernels.smooth_down.dispatch(pass, own.smooth_down, own.count);
    kernels.residual.dispatch(pass, own.residual, own.count);
    kernels.restrict_residual.dispatch(pass, own.restrict_residual, own.coarse_count);
  }
  kernels.cycle_tail.dispatch_groups(pass, cycle_tail_, 1);
}

void GridCycle::record_up(gpu::ComputePass& pass, const MultigridKernels& kernels) const {
  for (std::size_t l = tail_ - 1; l > 0; --l) {
    kernels.prolong.dispatch(pass, own_[l].prolong, own_[l].count);
    kernels.smooth_up.dispatch(pass, own_[l].smooth_up, own_[l].count);
  }
  if (levels_.size() > 1) kernels.correct_fine.dispatch(pass, correct_fine_, own_[0].count);
  kernels.prolong_fine.dispatch(pass, prolong_fine_, own_[0].count);
  kernels.finish.dispatch(pass, finish_[pass.parity()], own_[0].count);
}

void GridCycle::record(gpu::ComputePass& pass, const MultigridKernels& kernels) const {
  record_system(pass, kernels);
  record_matrices(pass, kernels);
  record_down(pass, kernels);
  record_up(pass, kernels);
}

}  // namespace weft
