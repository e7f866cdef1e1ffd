#include "method/projective_dynamics/relaxed_fabric.hpp"

#include "element/incidence.hpp"
#include "element/spring/neighbours.hpp"

namespace weft {
namespace {

struct SlicedPairs {
  std::vector<std::uint32_t> slices;
  std::vector<FabricPair> entries;
};

/// The pairs of each node in slices, as those of neighbours. Errors  Limit: more than 2^32 entries.
Result<SlicedPairs> sliced(const std::vector<NodePair>& pairs, const Body& body) {
  std::vector<std::uint32_t> ends;
  for (const NodePair& pair : pairs) ends.insert(ends.end(), {pair.a, pair.b});
  const mesh::Adjacency at = places_in(ends, 0, body.vertex_count);
  SlicedPairs made;
  WEFT_SET(made.slices, slice_starts(at));
  made.entries.resize(made.slices.back());
  for (std::uint32_t slice = 0; slice + 1 < made.slices.size(); ++slice)
    for (std::uint32_t entry = made.slices[slice]; entry < made.slices[slice + 1]; ++entry)
      made.entries[entry].other =
          body.first_vertex + std::min(slice * kSlice + entry % kSlice, body.vertex_count - 1);
  for (std::uint32_t node = 0; node < body.vertex_count; ++node) {
    std::uint32_t entry = made.slices[node / kSlice] + node % kSlice;
    for (const std::uint32_t place : at.row(node)) {
      const NodePair& pair = pairs[place / 2];
      made.entries[entry] = {body.first_vertex + (pair.a == node ? pair.b : pair.a),
                             static_cast<float>(pair.pull), static_cast<float>(pair.damping),
                             static_cast<float>(pair.bending)};
      entry += kSlice;
    }
  }
  return made;
}

}  // namespace

Result<void> RelaxedFabric::create_buffers(const SolverInputs& inputs, const Body& body) {
  gpu::Device& device = inputs.device;
  const Model& model = inputs.model.host;
  WEFT_SET(fabric_, FabricBuffers::create(device, model, body));
  const mesh::Adjacency corners =
      places_in(model.elements(ElementKind::Membrane, body).nodes, body.first_vertex, body.vertex_count);
  WEFT_SET(gathers_, gpu::Buffer<std::uint32_t>::create_from(
                         device, rows_then_entries(corners.offsets, corners.entries), "membranes of nodes"));
  WEFT_TRY(pairs, sliced(fabric_node_pairs(model, body), body));
  WEFT_SET(slices_, gpu::Buffer<std::uint32_t>::create_from(device, pairs.slices, "slices of pairs"));
  WEFT_SET(pairs_, gpu::Buffer<FabricPair>::create_from(device, pairs.entries, "pairs of nodes"));
  return {};
}

Result<RelaxedFabric> RelaxedFabric::create(const SolverInputs& inputs, const Body& body,
                                            const RelaxedState& relaxed, const ClothRates& rates) {
  const State& state = inputs.state;
  RelaxedFabric made;
  WEFT_CHECK(made.create_buffers(inputs, body));
  WEFT_SET(made.nodes_, gpu::create_uniform(inputs.device, relaxed_nodes(body, rates, relaxed.relaxation),
                                            "relaxed nodes"));
  const auto project = [&](std::size_t cycle, std::vector<gpu::Dispatch>& dispatches) -> Result<void> {
    WEFT_TRY(pull, dispatch_over(inputs, "method/projective_dynamics/pull_membranes.wgsl", body,
                                 [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                   return {state.steps,          made.fabric_.params,
                                           made.fabric_.corners, made.fabric_.slopes,
                                           made.gathers_,        state.position[p],
                                           relaxed.aim,          relaxed.ways_after(cycle, state, p),
                                           relaxed.left};
                                 }));
    dispatches.push_back(std::move(pull));
    WEFT_TRY(bend, dispatch_over(
                       inputs, "method/projective_dynamics/project_fabric.wgsl", body,
                       [&](std::size_t p) -> gpu::Dispatch::Bindings {
                         return {state.steps,
                                 made.nodes_,
                                 made.slices_,
                                 made.pairs_,
                                 state.position[p],
                                 relaxed.ways_after(cycle, state, p),
                                 relaxed.ways_after(cycle + 1, state, p),
                                 relaxed.left,
                                 relaxed.change[0],
                                 relaxed.aim};
                       },
                       holds_constant(inputs)));
    dispatches.push_back(std::move(bend));
    return {};
  };
  WEFT_SET(made.dispatches_,
           dispatches_of_cycles(
               inputs, body, relaxed, project,
               {"method/projective_dynamics/relax_fabric.wgsl", made.nodes_, {made.slices_, made.pairs_}}));
  return made;
}

}  // namespace weft
