#include "method/vbd/reference/vbd_stepper.hpp"

#include "element/spring/law.hpp"
#include "method/pieces/reference/piece_turn.hpp"
#include "method/reference_ways.hpp"
#include "method/sym3.hpp"

namespace weft::reference {
namespace {

/// Of the springs at a node.
NodePull pull_of_springs(const MassSpringSystem& system, std::span<const std::uint32_t> springs,
                         const Ways& ways, std::uint32_t node, double dt) {
  NodePull sum;
  for (const std::uint32_t at : springs) {
    const SpringLink& s = system.springs[at];
    const std::uint32_t other = s.node_a == node ? s.node_b : s.node_a;
    const Vec3d turn = ways.way[other] - ways.way[node];
    const Vec3d span = ways.start[other] - ways.start[node] + turn;
    const spring::Pull pull = spring::pull(span, turn / dt, s.law(), s.damping);
    const spring::Block block = spring::block(span, s.law());
    sum.force += pull.tension * pull.direction;
    sum.hessian += Sym3::identity(block.across);
    sum.hessian += Sym3::outer(block.direction, block.along + s.damping / dt);
  }
  return sum;
}

/// Equations (3) and (4): where a node's own part of what is minimised is least, its neighbours where they are. `aim`
/// is its way without springs.
NodeDescent descent(const NodePull& pull, const Ways& ways, std::uint32_t node, const Vec3d& aim, double dt) {
  const double mobility = dt * dt * ways.inverse_mass[node];
  const Vec3d slope = aim - ways.way[node] + mobility * pull.force;
  const Sym3 hessian = Sym3::identity(1) + mobility * pull.hessian;
  return {ways.way[node] + inverse(hessian) * slope, hessian};
}

}  // namespace

VbdStepper::VbdStepper(const Model& model, std::uint32_t iterations)
    : iterations_(iterations),
      springs_of_(incidence(model.elements(ElementKind::Spring), 0, model.rest_position.size())),
      pieces_(free_pieces(model, PiecesOf::Elements)),
      look_back_(model.rest_position.size()) {
  for (const Body& body : model.bodies) {
    Cloth cloth{color_nodes(model, body).nodes, std::nullopt, std::nullopt};
    if (body.fabric) cloth.fabric.emplace(model, body);
    if (body.solid) cloth.solid.emplace(model, body);
    cloths_.push_back(std::move(cloth));
  }
}

void VbdStepper::sweep(const Substep& substep, const std::vector<Vec3d>& aim, Ways& ways) {
  const MassSpringSystem& system = substep.system;
  std::size_t fabrics = 0, solids = 0;
  for (Cloth& cloth : cloths_) {
    const FabricCloth* fabric = cloth.fabric ? &system.fabrics[fabrics++] : nullptr;
    const SolidBody* solid = cloth.solid ? &system.solids[solids++] : nullptr;
    if (fabric != nullptr) cloth.fabric->begin_sweep(ways, *fabric, substep.dt);
    for (const std::uint32_t node : cloth.order) {
      if (ways.inverse_mass[node] == 0) continue;
      NodePull pull;
      if (fabric != nullptr)
        pull = cloth.fabric->pull(ways, *fabric, node - fabric->first, substep.dt);
      else if (solid != nullptr)
        pull = cloth.solid->pull(ways, *solid, node - solid->first, substep.dt);
      else
        pull = pull_of_springs(system, springs_of_.row(node), ways, node, substep.dt);
      const NodeDescent own = descent(pull, ways, node, aim[node], substep.dt);
      ways.way[node] = holds_[node] ? holds_[node]->descend(own) : own.free;
    }
  }
}

void VbdStepper::advance(const Substep& substep) {
  yield(substep.system);
  std::vector<Vec3d> aim;
  Ways ways = holds_.begin(substep, look_back_, aim);
  for (std::uint32_t k = 0; k < iterations_; ++k) sweep(substep, aim, ways);
  keep_momentum(
      pieces_, aim, [&](std::uint32_t node) { return !holds_.bears(node); }, ways);
  ways.end(substep);
  holds_.end(substep, ways.way);
}

}  // namespace weft::reference
