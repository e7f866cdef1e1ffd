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
  hold_nodes(substep);
  const std::vector<Vec3d> velocity = substep.system.velocity, velocity_before = look_back_.velocity_before();
  const std::vector<bool> known = look_back_.known();
  std::vector<Vec3d> aim;
  Ways ways = look_back_.begin(substep, aim);
  for (std::size_t node = 0; node < aim.size(); ++node) {
    if (!holds_[node] || ways.inverse_mass[node] == 0) continue;
    const Vec3d alone = holds_[node]->descend({aim[node], Sym3::identity(1)});
    if (!holds_[node]->bears()) continue;
    const Vec3d going_on = substep.dt * velocity[node], change = alone - going_on;
    const Vec3d felt = substep.dt * substep.ratio * (velocity[node] - velocity_before[node]);
    const bool is_pulled = bore_[node] && known[node] && dot(felt, change) < 0;
    ways.way[node] = is_pulled ? going_on + no_longer(felt, length(change)) : alone;
  }
  for (std::uint32_t k = 0; k < iterations_; ++k) sweep(substep, aim, ways);
  keep_momentum(
      pieces_, aim, [&](std::uint32_t node) { return !(holds_[node] && holds_[node]->bears()); }, ways);
  ways.end(substep);
  for (std::size_t node = 0; node < holds_.size(); ++node)
    if (holds_[node]) substep.system.velocity[node] = holds_[node]->moved(ways.way[node]) / substep.dt;
}

void VbdStepper::hold_nodes(const Substep& substep) {
  const std::vector<Vec3d>& velocity = substep.system.velocity;
  bore_ = held();
  bore_.resize(velocity.size());
  holds_.assign(velocity.size(), {});
  answers_ = static_cast<bool>(substep.pressed);
  if (!answers_) return;
  const std::vector<Press> presses = substep.pressed(velocity).presses;
  for (std::size_t node = 0; node < holds_.size(); ++node)
    if (substep.system.inverse_mass[node] > 0)
      holds_[node] = NodeHold::of(presses[node], substep.dt * velocity[node], substep.dt);
}

std::vector<bool> VbdStepper::held() const {
  if (!answers_) return {};
  std::vector<bool> held;
  for (const std::optional<NodeHold>& hold : holds_) held.push_back(hold && hold->bears() && hold->alike());
  return held;
}

}  // namespace weft::reference
