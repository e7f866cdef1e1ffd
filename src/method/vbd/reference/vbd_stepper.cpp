#include "method/vbd/reference/vbd_stepper.hpp"

#include "element/spring/law.hpp"
#include "method/reference_ways.hpp"
#include "method/sym3.hpp"

namespace weft::reference {
namespace {

/// Equations (3) and (4): the way of a node at which its own part of what is minimised is least, its neighbours where
/// they are. `aim` is its way without springs.
Vec3d descended(const MassSpringSystem& system, std::span<const std::uint32_t> springs, const Ways& ways,
                std::uint32_t node, const Vec3d& aim, double dt) {
  const double mobility = dt * dt * ways.inverse_mass[node];
  Vec3d slope = aim - ways.way[node];
  Sym3 hessian = Sym3::identity(1);
  for (const std::uint32_t at : springs) {
    const SpringLink& s = system.springs[at];
    const std::uint32_t other = s.node_a == node ? s.node_b : s.node_a;
    const Vec3d turn = ways.way[other] - ways.way[node];
    const Vec3d span = ways.start[other] - ways.start[node] + turn;
    const spring::Pull pull = spring::pull(span, turn / dt, s.law(), s.damping);
    const spring::Block block = spring::block(span, s.law());
    slope += mobility * pull.tension * pull.direction;
    hessian += Sym3::identity(mobility * block.across);
    hessian += Sym3::outer(block.direction, mobility * (block.along + s.damping / dt));
  }
  return ways.way[node] + inverse(hessian) * slope;
}

}  // namespace

VbdStepper::VbdStepper(const Model& model, std::uint32_t iterations)
    : iterations_(iterations),
      springs_of_(incidence(model.elements(ElementKind::Spring), 0, model.rest_position.size())),
      look_back_(model.rest_position.size()) {
  for (const Body& cloth : model.bodies) {
    const NodeColors colors = color_nodes(model, cloth);
    order_.insert(order_.end(), colors.nodes.begin(), colors.nodes.end());
  }
}

void VbdStepper::advance(const Substep& substep) {
  std::vector<Vec3d> aim;
  Ways ways = look_back_.begin(substep, aim);
  for (std::uint32_t sweep = 0; sweep < iterations_; ++sweep)
    for (const std::uint32_t node : order_)
      if (ways.inverse_mass[node] > 0)
        ways.way[node] = descended(substep.system, springs_of_.row(node), ways, node, aim[node], substep.dt);
  ways.end(substep);
}

}  // namespace weft::reference
