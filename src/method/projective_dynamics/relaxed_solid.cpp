#include "method/projective_dynamics/relaxed_solid.hpp"

namespace weft {

Result<void> RelaxedSolid::create_cycle(const SolverInputs& inputs, const Body& body,
                                        const RelaxedState& relaxed, std::size_t cycle) {
  const State& state = inputs.state;
  WEFT_TRY(pull, gpu::create_shared_kernel(inputs.device, "method/projective_dynamics/pull_tets.wgsl", {},
                                           inputs.workgroup_size));
  WEFT_TRY(pulling,
           gpu::Dispatch::create_by_parity(pull, pull->workgroups_of(solid_.layout.tets),
                                           [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                             return {state.steps,       solid_.params,
                                                     solid_.corners,    solid_.rests,
                                                     state.position[p], relaxed.ways_after(cycle, state, p),
                                                     turned_,           pulls_};
                                           }));
  dispatches_.push_back(std::move(pulling));
  WEFT_TRY(project, dispatch_over(
                        inputs, "method/projective_dynamics/project_solid.wgsl", body,
                        [&](std::size_t p) -> gpu::Dispatch::Bindings {
                          return {state.steps,
                                  nodes_,
                                  gathers_,
                                  pulls_,
                                  relaxed.aim,
                                  relaxed.ways_after(cycle, state, p),
                                  relaxed.ways_after(cycle + 1, state, p),
                                  relaxed.left,
                                  relaxed.change[0]};
                        },
                        holds_constant(inputs)));
  dispatches_.push_back(std::move(project));
  WEFT_TRY(back, gpu::create_shared_kernel(inputs.device, "method/projective_dynamics/pull_tets_back.wgsl",
                                           {}, inputs.workgroup_size));
  const ClothRelaxation nodes{"method/projective_dynamics/relax_solid.wgsl", nodes_, {gathers_, pulls_}};
  for (std::size_t iteration = 0; iteration < relaxed.weights[cycle].size(); ++iteration) {
    WEFT_TRY(pulling_back, gpu::Dispatch::create(back, back->workgroups_of(solid_.layout.tets),
                                                 {solid_.params, solid_.corners, solid_.rests, turned_,
                                                  relaxed.change[iteration % 2], pulls_}));
    dispatches_.push_back(std::move(pulling_back));
    WEFT_TRY(relax, relax_dispatch(inputs, body, relaxed, nodes, cycle, iteration));
    dispatches_.push_back(std::move(relax));
  }
  return {};
}

Result<RelaxedSolid> RelaxedSolid::create(const SolverInputs& inputs, const Body& body,
                                          const RelaxedState& relaxed, const ClothRates& rates) {
  gpu::Device& device = inputs.device;
  RelaxedSolid made;
  WEFT_SET(made.solid_, SolidBuffers::create(device, inputs.model.host, body));
  WEFT_SET(made.gathers_, gpu::Buffer<std::uint32_t>::create_from(
                              device, tet_corners_of_nodes(inputs.model.host, body), "tetrahedra of nodes"));
  WEFT_SET(made.turned_,
           gpu::Buffer<TurnedTet>::create(device, made.solid_.layout.tets, "turned tetrahedra"));
  WEFT_SET(made.pulls_, gpu::Buffer<Vec4f>::create(device, 4 * std::size_t{made.solid_.layout.tets},
                                                   "pulls of tetrahedra"));
  WEFT_SET(made.nodes_,
           gpu::create_uniform(device, relaxed_nodes(body, rates, relaxed.relaxation), "relaxed nodes"));
  for (std::size_t cycle = 0; cycle < relaxed.weights.size(); ++cycle)
    WEFT_CHECK(made.create_cycle(inputs, body, relaxed, cycle));
  return made;
}

}  // namespace weft
