#include "method/projection/solver_projection.hpp"

#include "method/holds/held_ways.hpp"
#include "model/tethers.hpp"

namespace weft {

void SolverProjection::record(gpu::ComputePass& pass, const contact::Stages& contact, std::uint32_t) const {
  contact.press(pass);
  gas_.record(pass);
  predict_way_.record(pass);
  begin_holds_.record(pass);
  for (std::uint32_t sweep = 0; sweep < iterations_; ++sweep) {
    for (const gpu::Dispatch& color : sweep == 0 ? first_sweep_ : later_sweep_) color.record(pass);
    for (const ProjectFabric& fabric : fabrics_) fabric.record(pass, sweep == 0);
    for (const ProjectSolid& solid : solids_) solid.record(pass, sweep == 0);
    keep_tethers_.record(pass);
    project_holds_.record(pass);
  }
  end_way_.record(pass);
  contact.search(pass);
  contact.measure(pass);
  contact.answer(pass);
  contact.hold_back(pass);
}

Result<void> SolverProjection::create_springs(const SolverInputs& inputs) {
  gpu::Device& device = inputs.device;
  const Springs springs = inputs.model.host.springs();
  const Colors& colors = inputs.model.host.colors(ElementKind::Spring);
  std::vector<std::uint32_t> order;
  for (std::uint32_t color = 0; color < colors.count(); ++color) {
    const std::size_t before = order.size();
    for (const std::uint32_t spring : colors.of(color))
      if (springs[spring].stiffness > 0) order.push_back(spring);  // others hold nothing
    WEFT_CHECK(colors_.add(device, static_cast<std::uint32_t>(order.size() - before)));
  }
  WEFT_TRY(packed, pack_springs(springs, order, inputs.model.vertex_count()));
  WEFT_SET(springs_, gpu::Buffer<PackedSpring>::create_from(device, packed.springs, "springs"));
  WEFT_SET(kinds_, gpu::Buffer<SpringKind>::create_from(device, packed.kinds, "spring kinds"));
  WEFT_SET(multiplier_, gpu::Buffer<float>::create(
                            device, kept_multipliers(multipliers_, packed.springs.size()), "multipliers"));
  return {};
}

Result<void> SolverProjection::create_nodes(const SolverInputs& inputs) {
  const State& state = inputs.state;
  const std::uint32_t count = inputs.model.vertex_count();
  WEFT_SET(corners_, corners_in_air(inputs));
  WEFT_SET(gas_, GasOnWays::create(inputs, [&](std::size_t p) -> const gpu::Buffer<Vec4f>& {
             return state.position[1 - p];
           }));
  WEFT_TRY(predict, gpu::create_shared_kernel(inputs.device, "method/projection/predict_way.wgsl",
                                              gas_.pushes(inputs), inputs.workgroup_size));
  WEFT_SET(predict_way_,
           gpu::Dispatch::create_by_parity(
               predict, predict->workgroups_of(count), [&](std::size_t p) -> gpu::Dispatch::Bindings {
                 return {state.steps,   state.position[p],     state.velocity[p], inputs.model.rest_position,
                         state.motions, state.position[1 - p], corners_};
               }));
  if (inputs.presses() != nullptr) WEFT_CHECK(create_holds(inputs));
  WEFT_SET(end_way_, create_end_held_way(inputs, aim_, false));
  return {};
}

Result<void> SolverProjection::create_holds(const SolverInputs& inputs) {
  const State& state = inputs.state;
  const std::uint32_t count = inputs.model.vertex_count();
  WEFT_SET(aim_, gpu::Buffer<Vec4f>::create(inputs.device, aim_words(inputs), "aims"));
  WEFT_TRY(begin, gpu::create_shared_kernel(inputs.device, "method/projection/begin_holds.wgsl", {},
                                            inputs.workgroup_size));
  WEFT_SET(begin_holds_,
           gpu::Dispatch::create_by_parity(begin, begin->workgroups_of(count),
                                           [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                             return {state.steps, state.velocity[p], *inputs.presses(), aim_};
                                           }));
  WEFT_TRY(project, gpu::create_shared_kernel(inputs.device, "method/projection/project_holds.wgsl", {},
                                              inputs.workgroup_size));
  WEFT_SET(project_holds_,
           gpu::Dispatch::create_by_parity(project, project->workgroups_of(count),
                                           [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                             return {state.steps, aim_, state.position[1 - p]};
                                           }));
  return {};
}

Result<void> SolverProjection::create_tethers(const SolverInputs& inputs) {
  const State& state = inputs.state;
  const TetherRows rows = tethers_of(inputs.model.host);
  if (!rows.any()) return {};
  const std::uint32_t count = inputs.model.vertex_count();
  std::vector<std::array<std::uint32_t, 2>> words;
  words.reserve(count + rows.tethers.size());
  for (std::uint32_t node = 0; node < count; ++node)
    words.push_back({count + rows.starts[node], count + rows.starts[node + 1]});
  for (const Tether& tether : rows.tethers) words.push_back({tether.to, bits_of(tether.length)});
  WEFT_SET(tethers_,
           (gpu::Buffer<std::array<std::uint32_t, 2>>::create_from(inputs.device, words, "tethers")));
  WEFT_TRY(kernel, gpu::create_shared_kernel(inputs.device, "method/projection/keep_tethers.wgsl", {},
                                             inputs.workgroup_size));
  WEFT_SET(keep_tethers_,
           gpu::Dispatch::create_by_parity(
               kernel, kernel->workgroups_of(count), [&](std::size_t p) -> gpu::Dispatch::Bindings {
                 return {state.steps, tethers_, state.position[p], state.position[1 - p]};
               }));
  return {};
}

Result<Sweep> SolverProjection::create_sweep(const SolverInputs& inputs, bool pulled) const {
  const State& state = inputs.state;
  WEFT_TRY(kernel, gpu::create_shared_kernel(inputs.device, "method/projection/project_springs.wgsl",
                                             sweep_constants(multipliers_, pulled), inputs.workgroup_size));
  return colors_.dispatches(
      kernel, [&](std::size_t p, const gpu::RawBuffer& color) -> gpu::Dispatch::Bindings {
        return {state.steps, color, springs_, kinds_, state.position[p], multiplier_, state.position[1 - p]};
      });
}

Result<std::unique_ptr<Solver>> SolverProjection::create(const SolverInputs& inputs, std::uint32_t iterations,
                                                         Multipliers multipliers) {
  auto made = std::make_unique<SolverProjection>();
  made->iterations_ = iterations;
  made->multipliers_ = multipliers;
  WEFT_CHECK(made->create_nodes(inputs));
  WEFT_CHECK(made->create_tethers(inputs));
  if (inputs.model.host.count(ElementKind::Spring) > 0) {
    WEFT_CHECK(made->create_springs(inputs));
    WEFT_SET(made->first_sweep_, made->create_sweep(inputs, false));
    if (iterations > 1) WEFT_SET(made->later_sweep_, made->create_sweep(inputs, true));
  }
  for (const Body& body : inputs.model.host.bodies) {
    if (body.solid) {
      WEFT_TRY(solid, ProjectSolid::create(inputs, body, multipliers));
      made->solids_.push_back(std::move(solid));
    }
    if (!body.fabric) continue;
    WEFT_TRY(fabric, ProjectFabric::create(inputs, body, multipliers));
    made->fabrics_.push_back(std::move(fabric));
  }
  return std::unique_ptr<Solver>(std::move(made));
}

}  // namespace weft
