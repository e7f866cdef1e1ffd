#include "method/projective_dynamics/relaxed_cloth.hpp"

namespace weft {

RelaxedNodes relaxed_nodes(const Body& body, const ClothRates& rates, const Relaxation& relaxation) {
  return {body.first_vertex, body.vertex_count, static_cast<float>(rates.stiffness),
          static_cast<float>(rates.damping), static_cast<float>(relaxation.radius)};
}

Result<RelaxedState> RelaxedState::create(const SolverInputs& inputs, const Relaxation& relaxation) {
  const std::uint32_t count = inputs.model.vertex_count();
  RelaxedState made;
  made.relaxation = relaxation;
  for (const std::vector<double>& weights : relaxation.cycles) {
    made.weights.emplace_back();
    for (const double weight : weights) {
      WEFT_TRY(uniform,
               gpu::create_uniform(inputs.device, Iteration{static_cast<float>(weight)}, "iteration"));
      made.weights.back().push_back(std::move(uniform));
    }
  }
  WEFT_SET(made.aim, gpu::Buffer<Vec4f>::create(inputs.device, aim_words(inputs), "aims"));
  WEFT_SET(made.way, gpu::Buffer<Vec4f>::create(inputs.device, count, "ways"));
  WEFT_SET(made.left, gpu::Buffer<Vec4f>::create(inputs.device, count, "what is left"));
  for (gpu::Buffer<Vec4f>& change : made.change)
    WEFT_SET(change, gpu::Buffer<Vec4f>::create(inputs.device, count, "changes of ways"));
  return made;
}

Result<gpu::Dispatch> relax_dispatch(const SolverInputs& inputs, const Body& body,
                                     const RelaxedState& relaxed, const ClothRelaxation& cloth,
                                     std::size_t cycle, std::size_t iteration) {
  const auto bindings = [&](std::size_t p) {
    gpu::Dispatch::Bindings all = {inputs.state.steps, cloth.nodes, relaxed.weights[cycle][iteration]};
    all.insert(all.end(), cloth.lists.begin(), cloth.lists.end());
    const gpu::Dispatch::Bindings nodes = {relaxed.change[iteration % 2], relaxed.change[(iteration + 1) % 2],
                                           relaxed.left, relaxed.ways_after(cycle + 1, inputs.state, p),
                                           relaxed.aim};
    all.insert(all.end(), nodes.begin(), nodes.end());
    return all;
  };
  return dispatch_over(inputs, cloth.shader, body, bindings, holds_constant(inputs));
}

}  // namespace weft
