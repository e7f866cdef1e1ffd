#include "method/multigrid/cycle.hpp"

#include "method/multigrid/kernels.hpp"

namespace weft {

using gpu::Dispatch;

void Cycle::record_first(gpu::ComputePass& pass) const {
  if (!corrects_) return;
  record_system(pass);
  record_matrices(pass);
  record_guess(pass);
  for (std::uint32_t k = 0; k < multigrid::kFirstIterations; ++k) record_iteration(pass);
  go_on_.record(pass);
}

void Cycle::record_last(gpu::ComputePass& pass, std::uint32_t iterations) const {
  if (corrects_) {
    record_solve_again(pass, iterations);
  } else {
    record_system(pass);
    record_matrices(pass);
    begin_guess(pass);
    record_step(pass, last_norm_);
    record_last_iterations(pass, iterations);
  }
  pair_end_.record(pass);
  finish_.record(pass);
  pair_finish_.record(pass);
}

void Cycle::record_newton(gpu::ComputePass& pass, std::uint32_t steps, std::uint32_t iterations) const {
  for (std::uint32_t step = 1; step < steps; ++step) {
    record_solve_again(pass, iterations);
    go_on_.record(pass);
  }
  record_system_again(pass);
  begin_measure_.record(pass);
  measure_.record(pass);
  finish_.record(pass);
}

void Cycle::record_solve_again(gpu::ComputePass& pass, std::uint32_t iterations) const {
  record_system_again(pass);
  record_matrices(pass);
  pair_force_again_.record(pass);
  begin_again_.record(pass);
  first_norm_again_.record(pass);
  record_last_iterations(pass, iterations);
}

void Cycle::record_last_iterations(gpu::ComputePass& pass, std::uint32_t iterations) const {
  for (std::uint32_t k = 0; k < iterations; ++k) {
    record_cycle(pass);
    record_step(pass, last_norm_);
  }
}

void Cycle::set_iterations(gpu::Device& device, std::uint32_t iterations, bool may_retry) const {
  ClothNodes nodes = own_nodes_;
  nodes.iterations = iterations;
  nodes.may_retry = may_retry ? 1 : 0;
  nodes_.write(device, std::span(&nodes, 1));
}

void Cycle::record_system(gpu::ComputePass& pass) const {
  predict_.record(pass);
  add_gas_.record(pass);
  add_air_.record(pass);
  record_gradient(pass);
}

void Cycle::record_system_again(gpu::ComputePass& pass) const {
  predict_again_.record(pass);
  add_gas_.record(pass);
  add_air_again_.record(pass);
  record_gradient(pass);
}

void Cycle::record_gradient(gpu::ComputePass& pass) const {
  for (const Dispatch& stage : elements_) stage.record(pass);
  gradient_.record(pass);
}

void Cycle::record_matrices(gpu::ComputePass& pass) const {
  for (const Level& level : levels_) level.coarsen.record(pass);
}

void Cycle::begin_guess(gpu::ComputePass& pass) const {
  pair_force_.record(pass);
  begin_solve_.record(pass);
  first_norm_.record(pass);
}

void Cycle::record_guess(gpu::ComputePass& pass) const {
  begin_guess(pass);
  record_step(pass, norm_);
}

void Cycle::record_iteration(gpu::ComputePass& pass) const {
  record_cycle(pass);
  record_step(pass, norm_);
}

void Cycle::record_cycle(gpu::ComputePass& pass) const {
  record_down(pass);
  record_up(pass);
  rho_.record(pass);
}

void Cycle::record_step(gpu::ComputePass& pass, const Dispatch& norm) const {
  pair_product_.record(pass);
  search_.record(pass);
  square_.record(pass);
  advance_.record(pass);
  norm.record(pass);
}

void Cycle::record_down(gpu::ComputePass& pass) const {
  for (std::size_t l = 0; l < tail_; ++l)
    for (const Dispatch& stage : levels_[l].down) stage.record(pass);
  tail_cycle_.record(pass);
}

void Cycle::record_up(gpu::ComputePass& pass) const {
  for (std::size_t l = tail_; l-- > 0;)
    for (const Dispatch& stage : levels_[l].up) stage.record(pass);
}

Result<void> Cycle::create_shared(const CycleInputs& inputs, const SharedKernels& kernels) {
  const State& state = inputs.state;
  const gpu::Workgroups nodes = for_each_cloth(kernels.predict->workgroups_of(own_nodes_.count));
  const gpu::Workgroups lone = for_each_cloth({});
  const Dispatch::Bindings sums = {nodes_, vectors_, partials_, state.statistics};
  WEFT_SET(predict_,
           Dispatch::create_by_parity(kernels.predict, nodes, [&](std::size_t p) -> Dispatch::Bindings {
             return {state.steps,
                     nodes_,
                     state.position[p],
                     state.velocity[p],
                     state.position[1 - p],
                     state.velocity[1 - p],
                     inputs.model.rest_position,
                     state.motions,
                     place_,
                     vectors_};
           }));
  WEFT_SET(begin_solve_, Dispatch::create(kernels.begin_solve, nodes,
                                          {nodes_, vectors_, partials_, place_, pair_sums(inputs),
                                           state.steps, norm_scales_}));
  WEFT_SET(advance_, Dispatch::create(kernels.advance, nodes, {nodes_, vectors_, partials_, norm_scales_}));
  WEFT_SET(first_norm_, Dispatch::create(kernels.first_norm, lone, sums));
  WEFT_SET(square_, Dispatch::create(kernels.square, lone, sums));
  WEFT_SET(norm_, Dispatch::create(kernels.norm, lone, sums));
  WEFT_SET(last_norm_, Dispatch::create(kernels.last_norm, lone, sums));
  WEFT_SET(rho_, Dispatch::create(kernels.rho, lone, sums));
  WEFT_SET(finish_,
           Dispatch::create_by_parity(kernels.finish, nodes, [&](std::size_t p) -> Dispatch::Bindings {
             return {state.steps,
                     nodes_,
                     place_,
                     holds_,
                     vectors_,
                     state.position[p],
                     state.velocity[p],
                     state.position[1 - p],
                     *inputs.predicted[p],
                     presses(inputs)};
           }));
  if (meets_contact(inputs))
    WEFT_SET(begin_anew_,
             Dispatch::create_by_parity(kernels.begin_anew, nodes, [&](std::size_t p) -> Dispatch::Bindings {
               return {nodes_, state.statistics, state.velocity[1 - p]};
             }));
  if (corrects_) WEFT_CHECK(create_second(inputs, kernels));
  if (inputs.corners != nullptr) {
    WEFT_SET(add_air_, create_air(inputs, kernels.add_air));
    if (corrects_) WEFT_SET(add_air_again_, create_air(inputs, kernels.add_air_again));
  }
  if (inputs.pairs == nullptr) return {};
  WEFT_SET(pair_finish_,
           Dispatch::create_by_parity(kernels.pair_finish, nodes, [&](std::size_t p) -> Dispatch::Bindings {
             return {nodes_, place_, *inputs.predicted[p], inputs.pairs->pair_sums};
           }));
  pair_force_kernel_ = kernels.pair_force;
  pair_force_again_kernel_ = kernels.pair_force_again;
  pair_product_kernel_ = kernels.pair_product;
  pair_end_kernel_ = kernels.pair_end;
  return bind_pairs(inputs);
}

Result<void> Cycle::create_second(const CycleInputs& inputs, const SharedKernels& kernels) {
  const State& state = inputs.state;
  const gpu::Workgroups nodes = for_each_cloth(kernels.go_on->workgroups_of(own_nodes_.count));
  WEFT_SET(go_on_, Dispatch::create_by_parity(kernels.go_on, nodes, [&](std::size_t p) -> Dispatch::Bindings {
             return {state.steps, nodes_, place_, vectors_, *inputs.predicted[p], pair_sums(inputs)};
           }));
  const Dispatch::Bindings begin = {nodes_,      vectors_,    partials_, place_, pair_sums(inputs),
                                    state.steps, norm_scales_};
  WEFT_SET(begin_again_, Dispatch::create(kernels.begin_again, nodes, begin));
  WEFT_SET(begin_measure_, Dispatch::create(kernels.begin_measure, nodes, begin));
  WEFT_SET(predict_again_,
           Dispatch::create_by_parity(kernels.predict_again, nodes, [&](std::size_t p) -> Dispatch::Bindings {
             return {
                 state.steps,           nodes_, state.position[p], state.velocity[p], state.position[1 - p],
                 state.velocity[1 - p], place_, vectors_,          pair_sums(inputs), presses(inputs)};
           }));
  const Dispatch::Bindings sums = {nodes_, vectors_, partials_, state.statistics};
  WEFT_SET(first_norm_again_, Dispatch::create(kernels.first_norm_again, for_each_cloth({}), sums));
  WEFT_SET(measure_, Dispatch::create(kernels.measure, for_each_cloth({}), sums));
  return {};
}

Result<Dispatch> Cycle::create_air(const CycleInputs& inputs, const gpu::SharedKernel& kernel) const {
  const State& state = inputs.state;
  return Dispatch::create_by_parity(
      kernel, for_each_cloth(kernel->workgroups_of(own_nodes_.count)),
      [&](std::size_t p) -> Dispatch::Bindings {
        return {state.steps,           nodes_, *inputs.corners, state.position[p], state.velocity[p],
                state.velocity[1 - p], place_, vectors_};
      });
}

Result<void> Cycle::bind_pairs(const CycleInputs& inputs) {
  const State& state = inputs.state;
  const ContactPairs& pairs = *inputs.pairs;
  const gpu::Workgroups groups = pair_force_kernel_->strided(pairs.room.near);
  const auto bind_force = [&](const gpu::SharedKernel& kernel) {
    return Dispatch::create_by_parity(kernel, groups, [&](std::size_t p) -> Dispatch::Bindings {
      return {state.steps,      nodes_,           place_,          vectors_,         state.position[p],
              state.statistics, pairs.pair_holds, pairs.pair_sums, state.velocity[p]};
    });
  };
  WEFT_SET(pair_force_, bind_force(pair_force_kernel_));
  WEFT_SET(pair_force_again_, bind_force(pair_force_again_kernel_));
  WEFT_SET(pair_product_,
           Dispatch::create(pair_product_kernel_, groups,
                            {nodes_, place_, vectors_, state.statistics, pairs.pair_holds, pairs.pair_sums}));
  WEFT_SET(pair_end_,
           Dispatch::create_by_parity(pair_end_kernel_, groups, [&](std::size_t p) -> Dispatch::Bindings {
             return {state.steps,      nodes_,           place_,         vectors_,       state.position[p],
                     state.statistics, pairs.pair_holds, pairs.contacts, pairs.pair_sums};
           }));
  return {};
}

}  // namespace weft
