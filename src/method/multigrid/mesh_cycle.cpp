#include "method/multigrid/mesh_cycle.hpp"

#include <algorithm>

#include "model/limited_edges.hpp"

namespace weft {

using gpu::Dispatch;

Result<MeshCycle> MeshCycle::create(const CycleInputs& inputs, const MeshKernels& kernels,
                                    const multigrid::SystemBodies& bodies) {
  MeshCycle made;
  const Body& body = bodies.first();
  const Model& model = inputs.model.host;
  const bool of_springs = multigrid::kind_of(body) == multigrid::CycleKind::Springs;
  const ElementPairs pairs = of_springs ? ElementPairs{} : element_pairs(model, bodies);
  std::vector<MeshLevel> levels = of_springs ? mesh_levels(model, body, model.springs(body))
                                             : mesh_levels(model, bodies, pairs.pairs, Blocks::General);
  made.bottom_ =
      multigrid::bottom_of(multigrid::mesh_scales(model, bodies, levels, inputs.step), multigrid::kMeshTail);
  made.finest_ = kernels.smoothing;
  levels.resize(made.bottom_.level + 1);
  const MeshLists lists = mesh_lists(levels, inputs.corners != nullptr, body.solid.has_value());
  made.shapes_ = lists.levels;
  WEFT_CHECK(made.create_buffers(inputs, {bodies.first_vertex(), bodies.vertex_count()}, made.shapes_,
                                 of_springs ? multigrid::kMeshTail : multigrid::kElementTail));
  if (body.solid)
    WEFT_SET(made.norm_scales_,
             gpu::Buffer<float>::create_from(
                 inputs.device, multigrid::norm_scales(model, bodies, inputs.step), "scales of norms"));
  WEFT_CHECK(made.create_lists(inputs.device, lists));
  WEFT_SET(made.blocks_,
           (gpu::Buffer<std::array<float, 2>>::create(
               inputs.device, (of_springs ? 3 : 5) * lists.entries.size(), "multigrid blocks")));
  WEFT_CHECK(made.create_shared(inputs, kernels.shared));
  if (body.gas) WEFT_CHECK(made.create_gas(inputs, kernels.shared));
  WEFT_CHECK(of_springs ? made.create_springs(inputs, kernels, body, lists)
                        : made.create_elements(inputs, kernels, bodies, pairs, lists));
  WEFT_CHECK(made.create_search(inputs, kernels));
  WEFT_CHECK(made.create_levels(kernels));
  return made;
}

Result<void> MeshCycle::create_gas(const CycleInputs& inputs, const SharedKernels& kernels) {
  WEFT_SET(add_gas_, Dispatch::create(kernels.add_gas, kernels.add_gas->workgroups_of(node_count(shapes_[0])),
                                      {nodes_, inputs.gas->gases(), inputs.gas->slopes(), place_, vectors_}));
  return {};
}

Result<void> MeshCycle::create_lists(gpu::Device& device, const MeshLists& lists) {
  const auto make = [&](auto& buffer, const auto& values, const char* label) -> Result<void> {
    using Made = std::remove_reference_t<decltype(buffer)>;
    WEFT_SET(buffer, Made::create_from(device, values, label));
    return {};
  };
  std::vector<BlockEntries> targets(lists.product_starts.size());
  for (std::size_t l = 1; l < lists.levels.size(); ++l)
    std::copy(lists.entries_of[l].begin(), lists.entries_of[l].end(),
              targets.begin() + lists.levels[l].first_product);
  WEFT_CHECK(make(lists_.row_starts, lists.row_starts, "multigrid row starts"));
  WEFT_CHECK(make(lists_.entries, lists.entries, "multigrid entries"));
  WEFT_CHECK(make(lists_.source_starts, lists.source_starts, "multigrid source starts"));
  WEFT_CHECK(make(lists_.sources, lists.sources, "multigrid sources"));
  WEFT_CHECK(make(lists_.product_starts, lists.product_starts, "multigrid product starts"));
  WEFT_CHECK(make(lists_.products, lists.products, "multigrid products"));
  WEFT_CHECK(make(lists_.targets, targets, "multigrid targets"));
  WEFT_CHECK(make(lists_.taps, lists.taps, "multigrid taps"));
  return {};
}

Result<void> MeshCycle::create_springs(const CycleInputs& inputs, const MeshKernels& kernels,
                                       const Body& body, const MeshLists& lists) {
  const Model& model = inputs.model.host;
  const Springs springs = model.springs(body);
  const std::vector<float> longest = longest_lengths(limited_edges(model, body), springs);
  const std::uint32_t nodes = lists.levels[0].node_count;
  std::vector<Vec4f> of_entries(nodes + 2 * springs.size());
  for (std::size_t s = 0; s < springs.size(); ++s)
    for (const std::uint32_t entry : lists.entries_of[0][nodes + s])
      of_entries[entry] = {springs[s].rest_length, springs[s].stiffness, springs[s].damping, longest[s]};
  WEFT_SET(springs_, gpu::Buffer<Vec4f>::create_from(inputs.device, of_entries, "multigrid springs"));
  WEFT_SET(gradient_,
           Dispatch::create(kernels.gradient, kernels.gradient->workgroups_of(nodes),
                            {inputs.state.steps, nodes_, levels_[0].levels, place_, holds_, vectors_, blocks_,
                             lists_.row_starts, lists_.entries, springs_, presses(inputs)}));
  return {};
}

Result<void> MeshCycle::create_elements(const CycleInputs& inputs, const MeshKernels& kernels,
                                        const multigrid::SystemBodies& bodies, const ElementPairs& pairs,
                                        const MeshLists& lists) {
  const gpu::RawBuffer& levels = levels_[0].levels;
  const MeshSystem mesh{levels, place_, vectors_, lists_.row_starts, lists_.entries, blocks_};
  const auto create_gradient = [&](const gpu::RawBuffer& gathers,
                                   const gpu::RawBuffer& forces) -> Result<void> {
    WEFT_SET(gradient_,
             Dispatch::create(kernels.gradient, kernels.gradient->workgroups_of(node_count(shapes_[0])),
                              {inputs.state.steps, nodes_, levels, place_, holds_, vectors_, blocks_,
                               lists_.row_starts, gathers, forces, presses(inputs)}));
    return {};
  };
  if (bodies.first().solid) {
    WEFT_SET(solid_, SolidSystem::create(inputs, kernels.solid, bodies, pairs, lists.entries_of[0], mesh));
    elements_ = solid_->take_stages();
    return create_gradient(solid_->gathers(), solid_->forces());
  }
  WEFT_SET(fabric_,
           FabricSystem::create(inputs, kernels.fabric, bodies.first(), pairs, lists.entries_of[0], mesh));
  elements_ = fabric_->take_stages();
  return create_gradient(fabric_->elements().gathers, fabric_->elements().forces);
}

Result<void> MeshCycle::create_search(const CycleInputs& inputs, const MeshKernels& kernels) {
  const gpu::Workgroups by_lanes =
      kernels.search->workgroups_of(multigrid::kLanes * std::uint64_t{node_count(shapes_[0])});
  WEFT_SET(search_, Dispatch::create(kernels.search, by_lanes,
                                     {levels_[0].levels, vectors_, blocks_, lists_.row_starts, lists_.entries,
                                      partials_, place_, pair_sums(inputs), nodes_}));
  return {};
}

Result<void> MeshCycle::create_levels(const MeshKernels& kernels) {
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    Level& level = levels_[l];
    const bool coarsest = l + 1 == shapes_.size();
    if (!coarsest) {
      WEFT_SET(level.coarsen,
               Dispatch::create(kernels.galerkin, kernels.galerkin->workgroups_of(shapes_[l + 1].block_count),
                                {level.levels, vectors_, blocks_, lists_.product_starts, lists_.products,
                                 lists_.targets}));
    }
    if (l >= tail_) continue;
    const gpu::Workgroups by_lanes =
        kernels.residual->workgroups_of(multigrid::kLanes * std::uint64_t{node_count(shapes_[l])});
    const gpu::Workgroups nodes = kernels.prolong->workgroups_of(node_count(shapes_[l]));
    const Dispatch::Bindings bindings = {level.levels, vectors_, blocks_, lists_.row_starts, lists_.entries};
    const LevelSmoothing& smoothing = l == 0 ? kernels.finest : kernels.coarse;
    for (const gpu::SharedKernel& sweep : smoothing.down)
      WEFT_CHECK(add_stage(level.down, Dispatch::create(sweep, by_lanes, bindings)));
    if (!coarsest) {
      const gpu::Workgroups coarse = kernels.restrict_residual->workgroups_of(node_count(shapes_[l + 1]));
      WEFT_CHECK(add_stage(level.down, Dispatch::create(kernels.residual, by_lanes, bindings)));
      WEFT_CHECK(add_stage(level.down,
                           Dispatch::create(kernels.restrict_residual, coarse,
                                            {level.levels, vectors_, lists_.source_starts, lists_.sources})));
      WEFT_CHECK(add_stage(level.up,
                           Dispatch::create(kernels.prolong, nodes, {level.levels, vectors_, lists_.taps})));
    }
    for (const gpu::SharedKernel& sweep : smoothing.up)
      WEFT_CHECK(add_stage(level.up, Dispatch::create(sweep, by_lanes, bindings)));
    if (l == 0)
      WEFT_CHECK(add_stage(level.up, Dispatch::create(kernels.smooth_last, by_lanes,
                                                      {level.levels, vectors_, blocks_, lists_.row_starts,
                                                       lists_.entries, partials_})));
  }
  if (shapes_.size() == 1) return {};
  const bool is_of_pieces = node_count(shapes_[tail_]) > multigrid::kMeshTail;
  WEFT_SET(tail_cycle_, Dispatch::create(is_of_pieces ? kernels.tail_of_pieces : kernels.tail, {1, 1},
                                         {tail_levels_, vectors_, blocks_, lists_.row_starts, lists_.entries,
                                          lists_.source_starts, lists_.sources, lists_.taps, sweeps_}));
  return {};
}

}  // namespace weft
