#include "method/vbd/solver_vbd.hpp"

#include "method/holds/held_ways.hpp"
#include "method/vbd/node_colors.hpp"

namespace weft {

void SolverVbd::record(gpu::ComputePass& pass, const contact::Stages& contact, std::uint32_t) const {
  contact.press(pass);
  gas_.record(pass);
  start_way_.record(pass);
  begin_holds_.record(pass);
  for (std::uint32_t sweep = 0; sweep < iterations_; ++sweep) {
    for (const gpu::Dispatch& color : sweep_) color.record(pass);
    for (const DescendFabric& fabric : fabrics_) fabric.record(pass, sweep == 0);
    for (const DescendSolid& solid : solids_) solid.record(pass);
  }
  pieces_.record(pass);
  end_way_.record(pass);
  contact.search(pass);
  contact.measure(pass);
  contact.answer(pass);
  contact.hold_back(pass);
}

Result<void> SolverVbd::create_nodes(const SolverInputs& inputs) {
  const State& state = inputs.state;
  WEFT_SET(aim_, gpu::Buffer<Vec4f>::create(inputs.device, aim_words(inputs), "aims"));
  WEFT_SET(corners_, corners_in_air(inputs));
  const WayOf way_of = [&](std::size_t p) -> const gpu::Buffer<Vec4f>& { return state.position[1 - p]; };
  WEFT_SET(gas_, GasOnWays::create(inputs, way_of));
  WEFT_SET(start_way_, create_start_way(inputs, corners_, gas_, aim_, way_of));
  WEFT_SET(begin_holds_, create_begin_holds(inputs, aim_, way_of));
  WEFT_SET(pieces_, PieceMotion::create_of_ways(inputs, aim_));
  WEFT_SET(end_way_, create_end_held_way(inputs, aim_, true));
  return {};
}

Result<void> SolverVbd::create_springs(const SolverInputs& inputs, const Body& body) {
  gpu::Device& device = inputs.device;
  const State& state = inputs.state;
  const Model& model = inputs.model.host;
  WEFT_TRY(built, build_neighbours(model.springs(body), model.incidence(ElementKind::Spring, body),
                                   body.first_vertex));
  const NodeColors colors = color_nodes(model, body);
  Cloth cloth;
  WEFT_SET(cloth.order, gpu::Buffer<std::uint32_t>::create_from(device, colors.nodes, "nodes by color"));
  WEFT_SET(cloth.slices, gpu::Buffer<std::uint32_t>::create_from(device, built.slices, "neighbour slices"));
  WEFT_SET(cloth.neighbours, gpu::Buffer<Neighbour>::create_from(device, built.entries, "neighbours"));
  WEFT_TRY(kernel, gpu::create_shared_kernel(device, "method/vbd/descend.wgsl", holds_constant(inputs),
                                             inputs.workgroup_size));
  NodesOfColor params;
  params.first_node = body.first_vertex;
  for (std::size_t kind = 0; kind < built.kinds.size(); ++kind)
    params.kinds[kind] = {built.kinds[kind].stiffness, built.kinds[kind].damping, 0, 0};
  for (std::uint32_t color = 0; color < colors.count(); ++color) {
    params.first = colors.starts[color];
    params.count = colors.starts[color + 1] - params.first;
    WEFT_TRY(uniform, gpu::create_uniform(device, params, "nodes of color"));
    WEFT_TRY(dispatch,
             gpu::Dispatch::create_by_parity(
                 kernel, kernel->workgroups_of(params.count), [&](std::size_t p) -> gpu::Dispatch::Bindings {
                   return {state.steps,      uniform,           cloth.order, cloth.slices,
                           cloth.neighbours, state.position[p], aim_,        state.position[1 - p]};
                 }));
    cloth.colors.push_back(std::move(uniform));
    sweep_.push_back(std::move(dispatch));
  }
  cloths_.push_back(std::move(cloth));
  return {};
}

Result<std::unique_ptr<Solver>> SolverVbd::create(const scene::Solver& settings, const SolverInputs& inputs) {
  auto made = std::make_unique<SolverVbd>();
  made->iterations_ = settings.iterations;
  WEFT_CHECK(made->create_nodes(inputs));
  for (const Body& body : inputs.model.host.bodies) {
    if (body.solid) {
      WEFT_TRY(solid, DescendSolid::create(inputs, body, made->aim_));
      made->solids_.push_back(std::move(solid));
      continue;
    }
    if (!body.fabric) {
      WEFT_CHECK(made->create_springs(inputs, body));
      continue;
    }
    WEFT_TRY(fabric, DescendFabric::create(inputs, body, made->aim_));
    made->fabrics_.push_back(std::move(fabric));
  }
  return std::unique_ptr<Solver>(std::move(made));
}

}  // namespace weft
