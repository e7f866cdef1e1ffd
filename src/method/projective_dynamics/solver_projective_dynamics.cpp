#include "method/projective_dynamics/solver_projective_dynamics.hpp"

#include <algorithm>

namespace weft {

void SolverProjectiveDynamics::record(gpu::ComputePass& pass, const contact::Stages& contact,
                                      std::uint32_t) const {
  contact.press(pass);
  gas_.record(pass);
  start_way_.record(pass);
  begin_holds_.record(pass);
  for (const RelaxedSprings& cloth : springs_)
    for (const gpu::Dispatch& dispatch : cloth.dispatches()) dispatch.record(pass);
  for (const RelaxedFabric& cloth : fabrics_)
    for (const gpu::Dispatch& dispatch : cloth.dispatches()) dispatch.record(pass);
  for (const RelaxedSolid& body : solids_)
    for (const gpu::Dispatch& dispatch : body.dispatches()) dispatch.record(pass);
  pieces_.record(pass);
  end_way_.record(pass);
  contact.search(pass);
  contact.measure(pass);
  contact.answer(pass);
  contact.hold_back(pass);
}

Result<std::unique_ptr<Solver>> SolverProjectiveDynamics::create(const scene::Solver& settings,
                                                                 const SolverInputs& inputs) {
  auto made = std::make_unique<SolverProjectiveDynamics>();
  const Model& model = inputs.model.host;
  std::vector<ClothRates> rates;
  double most = 0;
  for (const Body& body : model.bodies) {
    rates.push_back(cloth_rates(model, body));
    most = std::max(most, rates.back().at(inputs.step));
  }
  RelaxedState& relaxed = made->relaxed_;
  WEFT_SET(relaxed, RelaxedState::create(inputs, make_relaxation(most, settings.iterations)));
  WEFT_SET(made->corners_, corners_in_air(inputs));
  const WayOf way_of = [&](std::size_t p) -> const gpu::Buffer<Vec4f>& {
    return relaxed.ways_after(0, inputs.state, p);
  };
  WEFT_SET(made->gas_, GasOnWays::create(inputs, way_of));
  WEFT_SET(made->start_way_, create_start_way(inputs, made->corners_, made->gas_, relaxed.aim, way_of));
  WEFT_SET(made->begin_holds_, create_begin_holds(inputs, relaxed.aim, way_of));
  WEFT_SET(made->pieces_, PieceMotion::create_of_ways(inputs, relaxed.aim));
  WEFT_SET(made->end_way_, create_end_held_way(inputs, relaxed.aim, true));
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Body& body = model.bodies[b];
    if (body.fabric) {
      WEFT_TRY(cloth, RelaxedFabric::create(inputs, body, relaxed, rates[b]));
      made->fabrics_.push_back(std::move(cloth));
    } else if (body.solid) {
      WEFT_TRY(solid, RelaxedSolid::create(inputs, body, relaxed, rates[b]));
      made->solids_.push_back(std::move(solid));
    } else {
      WEFT_TRY(cloth, RelaxedSprings::create(inputs, body, relaxed, rates[b]));
      made->springs_.push_back(std::move(cloth));
    }
  }
  return std::unique_ptr<Solver>(std::move(made));
}

}  // namespace weft
