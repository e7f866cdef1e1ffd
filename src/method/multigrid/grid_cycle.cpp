#include "method/multigrid/grid_cycle.hpp"

#include <algorithm>

#include "element/spring/spring_grid.hpp"

namespace weft {

using gpu::Dispatch;

namespace {

/// A workgroup for each tile of so many nodes a side.
gpu::Workgroups tiles(const gpu::Kernel& kernel, const GridLevelParams& level, std::uint32_t side) {
  const std::uint64_t across = (level.nx + side - 1) / side, along = (level.ny + side - 1) / side;
  return kernel.workgroups_of(across * along * kernel.workgroup_size());
}

/// Of all springs of the cloths: src/method/multigrid/grid_springs.wgsl.
std::size_t poses(const CycleInputs& inputs, const EqualCloths& cloths) {
  return std::size_t{any_bend_springs(inputs.model.host) ? 6U : 4U} * cloths.count *
         cloths.first.vertex_count;
}

}  // namespace

std::size_t most_cloths(const Body& body, const gpu::Limits& limits, bool air) {
  const std::size_t vectors = grid_level_params(body, air)[0].vectors + multigrid::kSolveWords;
  return std::min<std::size_t>(limits.max_workgroups_per_dimension,
                               limits.max_storage_binding_size / (sizeof(Vec4f) * vectors));
}

Result<GridCycle> GridCycle::create(const CycleInputs& inputs, const GridKernels& kernels,
                                    const EqualCloths& cloths) {
  const Body& body = cloths.first;
  GridCycle made;
  made.bottom_ = multigrid::bottom_of(multigrid::grid_scales(inputs.model.host, body, inputs.step),
                                      multigrid::kGridTail);
  made.finest_ = kernels.smoothing;
  made.shapes_ = grid_level_params(body, inputs.corners != nullptr, made.bottom_.level + 1);
  WEFT_CHECK(made.create_buffers(inputs, {cloths.first.first_vertex, cloths.first.vertex_count, cloths.count},
                                 made.shapes_, multigrid::kGridTail));
  WEFT_SET(made.grid_,
           gpu::create_uniform(inputs.device, spring_grid(*body.grid, body.material(), body.first_vertex),
                               "spring grid"));
  const std::size_t operators = std::size_t{cloths.count} * made.shapes_[0].operators;
  WEFT_SET(made.operators_,
           gpu::Buffer<multigrid::BlockPart>::create(inputs.device, operators, "multigrid operators"));
  WEFT_SET(made.springs_, (gpu::Buffer<std::array<std::uint32_t, 2>>::create(
                              inputs.device, poses(inputs, cloths), "poses of springs")));
  WEFT_CHECK(made.create_system(inputs, kernels));
  WEFT_CHECK(made.create_fine(inputs, kernels));
  WEFT_CHECK(made.create_coarse(kernels));
  return made;
}

Result<void> GridCycle::create_system(const CycleInputs& inputs, const GridKernels& kernels) {
  const gpu::Buffer<StepBlock>& steps = inputs.state.steps;
  const gpu::RawBuffer& levels = levels_[0].levels;
  const gpu::Workgroups nodes = for_each_cloth(kernels.gradient->workgroups_of(node_count(shapes_[0])));
  WEFT_CHECK(create_shared(inputs, kernels.shared));
  WEFT_SET(gradient_,
           Dispatch::create(kernels.gradient, nodes,
                            {steps, grid_, levels, place_, holds_, vectors_, springs_, presses(inputs)}));
  WEFT_SET(search_, Dispatch::create(kernels.search, nodes,
                                     {steps, grid_, levels, place_, holds_, vectors_, springs_, partials_,
                                      pair_sums(inputs), nodes_}));
  return {};
}

Result<void> GridCycle::create_fine(const CycleInputs& inputs, const GridKernels& kernels) {
  Level& fine = levels_[0];
  const gpu::Workgroups nodes = for_each_cloth(kernels.smooth_fine->workgroups_of(node_count(shapes_[0])));
  const Dispatch::Bindings bindings = {inputs.state.steps, grid_,   fine.levels, place_, holds_,
                                       vectors_,           springs_};
  const bool alone = shapes_.size() == 1;
  WEFT_CHECK(add_stage(fine.down, Dispatch::create(kernels.smooth_fine, nodes, bindings)));
  if (!alone)
    WEFT_CHECK(
        add_stage(fine.up, Dispatch::create(kernels.correct_fine, nodes, {fine.levels, place_, vectors_})));
  WEFT_CHECK(add_stage(fine.up, Dispatch::create(kernels.prolong_fine, nodes, bindings)));
  WEFT_CHECK(add_stage(fine.up, Dispatch::create(kernels.smooth_last, nodes,
                                                 {inputs.state.steps, grid_, fine.levels, place_, holds_,
                                                  vectors_, springs_, partials_})));
  if (alone) return {};
  const gpu::Workgroups coarse = for_each_cloth(kernels.galerkin_fine->workgroups_of(node_count(shapes_[1])));
  WEFT_SET(fine.coarsen, Dispatch::create(kernels.galerkin_fine, coarse,
                                          {inputs.state.steps, grid_, fine.levels, place_, holds_, vectors_,
                                           springs_, operators_}));
  WEFT_CHECK(add_stage(fine.down, Dispatch::create(kernels.residual_fine, nodes, bindings)));
  WEFT_CHECK(
      add_stage(fine.down, Dispatch::create(kernels.restrict_residual, coarse, {fine.levels, vectors_})));
  WEFT_SET(tail_cycle_, Dispatch::create(kernels.cycle_tail, for_each_cloth({}),
                                         {tail_levels_, vectors_, operators_, sweeps_}));
  return {};
}

// Between the finest level and the tail, one dispatch does all stages down and one all of those up.
Result<void> GridCycle::create_coarse(const GridKernels& kernels) {
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    Level& level = levels_[l];
    const Dispatch::Bindings bindings = {level.levels, vectors_, operators_};
    const std::uint32_t coarse_nodes = node_count(shapes_[l + 1]);
    WEFT_SET(level.coarsen, Dispatch::create(kernels.galerkin,
                                             for_each_cloth(kernels.galerkin->workgroups_of(
                                                 std::uint64_t{multigrid::kBlocks} * coarse_nodes)),
                                             bindings));
    if (l >= tail_) continue;
    const gpu::Workgroups down =
        for_each_cloth(tiles(*kernels.descend, shapes_[l + 1], multigrid::kCoarseTile));
    const gpu::Workgroups up = for_each_cloth(tiles(*kernels.ascend, shapes_[l], multigrid::kTile));
    WEFT_CHECK(add_stage(level.down, Dispatch::create(kernels.descend, down, bindings)));
    WEFT_CHECK(add_stage(level.up, Dispatch::create(kernels.ascend, up, bindings)));
  }
  return {};
}

}  // namespace weft
