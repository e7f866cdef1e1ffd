#include "method/projective_dynamics/relaxed_springs.hpp"

namespace weft {

Result<RelaxedSprings> RelaxedSprings::create(const SolverInputs& inputs, const Body& body,
                                              const RelaxedState& relaxed, const ClothRates& rates) {
  gpu::Device& device = inputs.device;
  const Model& model = inputs.model.host;
  const State& state = inputs.state;
  WEFT_TRY(built, build_neighbours(model.springs(body), model.incidence(ElementKind::Spring, body),
                                   body.first_vertex));
  SpringKindsBlock kinds;
  for (std::size_t kind = 0; kind < built.kinds.size(); ++kind)
    kinds.kinds[kind] = {built.kinds[kind].stiffness, built.kinds[kind].damping, 0, 0};
  RelaxedSprings made;
  WEFT_SET(made.slices_, gpu::Buffer<std::uint32_t>::create_from(device, built.slices, "neighbour slices"));
  WEFT_SET(made.neighbours_, gpu::Buffer<Neighbour>::create_from(device, built.entries, "neighbours"));
  WEFT_SET(made.kinds_, gpu::create_uniform(device, kinds, "kinds of springs"));
  WEFT_SET(made.nodes_,
           gpu::create_uniform(device, relaxed_nodes(body, rates, relaxed.relaxation), "relaxed nodes"));
  const auto project = [&](std::size_t cycle, std::vector<gpu::Dispatch>& dispatches) -> Result<void> {
    WEFT_TRY(dispatch, dispatch_over(
                           inputs, "method/projective_dynamics/project_springs.wgsl", body,
                           [&](std::size_t p) -> gpu::Dispatch::Bindings {
                             return {state.steps,
                                     made.nodes_,
                                     made.kinds_,
                                     made.slices_,
                                     made.neighbours_,
                                     state.position[p],
                                     relaxed.aim,
                                     relaxed.ways_after(cycle, state, p),
                                     relaxed.ways_after(cycle + 1, state, p),
                                     relaxed.left,
                                     relaxed.change[0]};
                           },
                           holds_constant(inputs)));
    dispatches.push_back(std::move(dispatch));
    return {};
  };
  WEFT_SET(made.dispatches_, dispatches_of_cycles(inputs, body, relaxed, project,
                                                  {"method/projective_dynamics/relax_springs.wgsl",
                                                   made.nodes_,
                                                   {made.kinds_, made.slices_, made.neighbours_}}));
  return made;
}

}  // namespace weft
