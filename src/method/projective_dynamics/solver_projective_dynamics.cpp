#include "method/projective_dynamics/solver_projective_dynamics.hpp"

#include <algorithm>

#include "method/ways.hpp"

namespace weft {

void SolverProjectiveDynamics::record(gpu::ComputePass& pass, const contact::Stages& contact,
                                      std::uint32_t) const {
  start_way_.record(pass);
  for (std::size_t iteration = 0; iteration < cloths_.front().iterations.size(); ++iteration)
    for (const Cloth& cloth : cloths_) cloth.iterations[iteration].record(pass);
  end_way_.record(pass);
  contact.search(pass);
  contact.measure(pass);
  contact.answer(pass);
  contact.hold_back(pass);
}

Result<void> SolverProjectiveDynamics::create_nodes(const SolverInputs& inputs) {
  const std::uint32_t count = inputs.model.vertex_count();
  WEFT_SET(aim_, gpu::Buffer<Vec4f>::create(inputs.device, count, "aims"));
  WEFT_SET(way_, gpu::Buffer<Vec4f>::create(inputs.device, count, "ways"));
  WEFT_SET(left_, gpu::Buffer<Vec4f>::create(inputs.device, count, "what is left"));
  for (gpu::Buffer<Vec4f>& change : change_)
    WEFT_SET(change, gpu::Buffer<Vec4f>::create(inputs.device, count, "changes of ways"));
  WEFT_SET(corners_, corners_in_air(inputs));
  WEFT_SET(start_way_,
           create_start_way(inputs, corners_, aim_, [&](std::size_t p) -> const gpu::Buffer<Vec4f>& {
             return ways_after(0, inputs.state, p);
           }));
  WEFT_SET(end_way_, create_end_way(inputs, true));
  return {};
}

Result<void> SolverProjectiveDynamics::create_cloth(const SolverInputs& inputs, const Body& body,
                                                    const SpringRates& rates) {
  gpu::Device& device = inputs.device;
  const Model& model = inputs.model.host;
  WEFT_TRY(built, build_neighbours(model.springs(body), model.incidence(ElementKind::Spring, body),
                                   body.first_vertex));
  RelaxedNodes nodes{body.first_vertex, body.vertex_count, static_cast<float>(rates.stiffness),
                     static_cast<float>(rates.damping), static_cast<float>(relaxation_.radius)};
  for (std::size_t kind = 0; kind < built.kinds.size(); ++kind)
    nodes.kinds[kind] = {built.kinds[kind].stiffness, built.kinds[kind].damping, 0, 0};
  Cloth cloth{.count = body.vertex_count};
  WEFT_SET(cloth.slices, gpu::Buffer<std::uint32_t>::create_from(device, built.slices, "neighbour slices"));
  WEFT_SET(cloth.neighbours, gpu::Buffer<Neighbour>::create_from(device, built.entries, "neighbours"));
  WEFT_SET(cloth.nodes, gpu::create_uniform(device, nodes, "relaxed nodes"));
  for (std::size_t cycle = 0; cycle < weights_.size(); ++cycle) {
    WEFT_TRY(projection, create_projection(inputs, cloth, cycle));
    cloth.iterations.push_back(std::move(projection));
    for (std::size_t iteration = 0; iteration < weights_[cycle].size(); ++iteration) {
      WEFT_TRY(relaxed, create_iteration(inputs, cloth, cycle, iteration));
      cloth.iterations.push_back(std::move(relaxed));
    }
  }
  cloths_.push_back(std::move(cloth));
  return {};
}

Result<gpu::Dispatch> SolverProjectiveDynamics::create_projection(const SolverInputs& inputs,
                                                                  const Cloth& cloth,
                                                                  std::size_t cycle) const {
  const State& state = inputs.state;
  WEFT_TRY(kernel, gpu::create_shared_kernel(inputs.device, "method/projective_dynamics/project_springs.wgsl",
                                             {}, inputs.workgroup_size));
  return gpu::Dispatch::create_by_parity(kernel, kernel->workgroups_of(cloth.count),
                                         [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                           return {state.steps,
                                                   cloth.nodes,
                                                   cloth.slices,
                                                   cloth.neighbours,
                                                   state.position[p],
                                                   aim_,
                                                   ways_after(cycle, state, p),
                                                   ways_after(cycle + 1, state, p),
                                                   left_,
                                                   change_[0]};
                                         });
}

Result<gpu::Dispatch> SolverProjectiveDynamics::create_iteration(const SolverInputs& inputs,
                                                                 const Cloth& cloth, std::size_t cycle,
                                                                 std::size_t iteration) const {
  const State& state = inputs.state;
  WEFT_TRY(kernel, gpu::create_shared_kernel(inputs.device, "method/projective_dynamics/relax_nodes.wgsl", {},
                                             inputs.workgroup_size));
  return gpu::Dispatch::create_by_parity(kernel, kernel->workgroups_of(cloth.count),
                                         [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                           return {state.steps,
                                                   cloth.nodes,
                                                   weights_[cycle][iteration],
                                                   cloth.slices,
                                                   cloth.neighbours,
                                                   change_[iteration % 2],
                                                   change_[(iteration + 1) % 2],
                                                   left_,
                                                   ways_after(cycle + 1, state, p)};
                                         });
}

Result<std::unique_ptr<Solver>> SolverProjectiveDynamics::create(const scene::Solver& settings,
                                                                 const SolverInputs& inputs) {
  auto made = std::make_unique<SolverProjectiveDynamics>();
  const Model& model = inputs.model.host;
  std::vector<SpringRates> rates;
  double most = 0;
  for (const Body& body : model.bodies) {
    rates.push_back(spring_rates(model, body));
    most = std::max(most, rates.back().at(inputs.step));
  }
  made->relaxation_ = make_relaxation(most, settings.iterations);
  for (const std::vector<double>& weights : made->relaxation_.cycles) {
    made->weights_.emplace_back();
    for (const double weight : weights) {
      WEFT_TRY(uniform,
               gpu::create_uniform(inputs.device, Iteration{static_cast<float>(weight)}, "iteration"));
      made->weights_.back().push_back(std::move(uniform));
    }
  }
  WEFT_CHECK(made->create_nodes(inputs));
  for (std::size_t body = 0; body < model.bodies.size(); ++body)
    WEFT_CHECK(made->create_cloth(inputs, model.bodies[body], rates[body]));
  return std::unique_ptr<Solver>(std::move(made));
}

}  // namespace weft
