#include "method/mass_spring/solver_mass_spring.hpp"

#include <algorithm>

#include "method/corners.hpp"

namespace weft {

namespace {

// Most nodes for which two substeps at once are quicker than two dispatches, on an H100: docs/decisions.md.
constexpr std::uint32_t kMostForTwo = 160000;

/// Whether a dispatch costs more than the redundant work of two substeps at once.
bool two_pay(const SolverInputs& inputs) {
  if (inputs.state.steps.size() < 2) return false;  // no frame has two
  if (inputs.two_steps) return *inputs.two_steps;
  return inputs.device.adapter().type != "CPU" && inputs.model.vertex_count() <= kMostForTwo;
}

}  // namespace

void SolverMassSpring::record(gpu::ComputePass& pass, const contact::Stages& contact,
                              std::uint32_t count) const {
  if (count == 2) {
    for (const AdvanceGridTwice& advance : twice_) advance.record(pass);
    return;
  }
  record_predict(pass);
  contact.search(pass);
  contact.measure(pass);
  contact.answer(pass);
  contact.hold_back(pass);
}

void SolverMassSpring::fill(StepBlock::Method& part) const {
  part.spring_count = spring_count_;
  part.force_scale = fixed_point_.scale;
  part.force_limit = fixed_point_.limit;
}

void SolverMassSpring::record_predict(gpu::ComputePass& pass) const {
  if (spring_centric_) {
    if (spring_centric_->spring_forces) spring_centric_->spring_forces->record(pass);  // Algorithm 1
    if (spring_centric_->spring_block_forces) spring_centric_->spring_block_forces->record(pass);
    spring_centric_->integrate_forces.record(pass);  // gravity enters here, so it needs no buffer
  }
  for (const AdvanceGrid& advance : grids_) advance.record(pass);
  for (const AdvanceMesh& advance : meshes_) advance.record(pass);
  for (const AdvanceFabric& advance : fabrics_) advance.record(pass);
  for (const AdvanceSolid& advance : solids_) advance.record(pass);
  gas_.record(pass);
  push_by_gas_.record(pass);
  push_by_air_.record(pass);
}

Result<void> SolverMassSpring::create_gas(const SolverInputs& inputs) {
  const State& state = inputs.state;
  WEFT_SET(gas_, EnclosedGas::create(inputs, EnclosedGas::At::Start));
  if (!gas_.any()) return {};
  WEFT_TRY(kernel, gpu::create_shared_kernel(inputs.device, "method/mass_spring/push_by_gas.wgsl", {},
                                             inputs.workgroup_size));
  WEFT_SET(push_by_gas_,
           gpu::Dispatch::create_by_parity(kernel, kernel->workgroups_of(inputs.model.vertex_count()),
                                           [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                             return {state.steps,
                                                     gas_.gases(),
                                                     gas_.slopes(),
                                                     state.position[p],
                                                     inputs.model.rest_position,
                                                     state.motions,
                                                     state.position[1 - p],
                                                     *inputs.predicted()[p]};
                                           }));
  return {};
}

Result<void> SolverMassSpring::create_air(const SolverInputs& inputs) {
  const State& state = inputs.state;
  WEFT_SET(corners_, air_corners(inputs.device, inputs.model.host));
  WEFT_TRY(kernel, gpu::create_shared_kernel(inputs.device, "method/mass_spring/push_by_air.wgsl", {},
                                             inputs.workgroup_size));
  WEFT_SET(push_by_air_,
           gpu::Dispatch::create_by_parity(kernel, kernel->workgroups_of(inputs.model.vertex_count()),
                                           [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                             return {state.steps,
                                                     corners_,
                                                     state.position[p],
                                                     state.velocity[p],
                                                     inputs.model.rest_position,
                                                     state.motions,
                                                     state.position[1 - p],
                                                     *inputs.predicted()[p]};
                                           }));
  return {};
}

Result<void> SolverMassSpring::create_spring_centric(const scene::Solver& settings,
                                                     const SolverInputs& inputs) {
  SpringCentric made;
  const Springs springs = inputs.model.host.springs();
  spring_count_ = static_cast<std::uint32_t>(springs.size());
  fixed_point_ = force_fixed_point(springs, inputs.model.vertex_count());
  WEFT_TRY(force,
           gpu::Buffer<std::int32_t>::create(inputs.device, 3UL * inputs.model.vertex_count(), "force"));
  made.force = std::move(force);
  if (settings.forces == scene::Forces::SpringBlocks) {
    WEFT_TRY(forces, SpringBlockForces::create(inputs.device, inputs.model, inputs.state, springs, made.force,
                                               inputs.workgroup_size));
    made.spring_block_forces = std::move(forces);
  } else {
    WEFT_TRY(forces,
             SpringForces::create(inputs.device, inputs.state, springs, made.force, inputs.workgroup_size));
    made.spring_forces = std::move(forces);
  }
  WEFT_SET(made.integrate_forces, IntegrateForces::create(inputs, made.force));
  spring_centric_ = std::move(made);
  return {};
}

Result<void> SolverMassSpring::create_node_centric(const SolverInputs& inputs) {
  const auto& bodies = inputs.model.host.bodies;
  const bool two = inputs.contacts == nullptr && !inputs.air && two_pay(inputs) &&
                   std::all_of(bodies.begin(), bodies.end(),
                               [](const Body& body) { return body.grid.has_value() && !body.fabric; });
  const std::size_t most = inputs.device.limits().max_workgroups_per_dimension;
  for (std::size_t b = 0; b < bodies.size();) {
    const Body& body = bodies[b];
    if (body.solid) {
      WEFT_TRY(advance, AdvanceSolid::create(inputs, body));
      solids_.push_back(std::move(advance));
      ++b;
      continue;
    }
    if (body.fabric) {
      WEFT_TRY(advance, AdvanceFabric::create(inputs, body));
      fabrics_.push_back(std::move(advance));
      ++b;
      continue;
    }
    if (!body.grid) {
      WEFT_TRY(advance, AdvanceMesh::create(inputs, body));
      meshes_.push_back(std::move(advance));
      ++b;
      continue;
    }
    const EqualCloths cloths = {body, equal_grids(std::span(bodies).subspan(b), most)};
    b += cloths.count;
    WEFT_TRY(advance, AdvanceGrid::create(inputs, cloths));
    grids_.push_back(std::move(advance));
    if (!two) continue;
    WEFT_TRY(twice, AdvanceGridTwice::create(inputs, cloths));
    twice_.push_back(std::move(twice));
  }
  return {};
}

Result<std::unique_ptr<Solver>> SolverMassSpring::create(const scene::Solver& settings,
                                                         const SolverInputs& inputs) {
  auto made = std::make_unique<SolverMassSpring>();
  if (settings.forces == scene::Forces::NodeCentric) {
    WEFT_CHECK(made->create_node_centric(inputs));
  } else {
    WEFT_CHECK(made->create_spring_centric(settings, inputs));
  }
  WEFT_CHECK(made->create_gas(inputs));
  if (inputs.air) WEFT_CHECK(made->create_air(inputs));
  return std::unique_ptr<Solver>(std::move(made));
}

}  // namespace weft
