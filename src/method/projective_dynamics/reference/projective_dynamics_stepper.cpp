#include "method/projective_dynamics/reference/projective_dynamics_stepper.hpp"

#include <algorithm>

#include "element/spring/law.hpp"
#include "method/pieces/reference/piece_turn.hpp"
#include "method/projective_dynamics/bounded_yarns.hpp"

namespace weft::reference {
namespace {

void add_springs(const MassSpringSystem& system, const Ways& ways, double dt, std::vector<Vec3d>& pulls) {
  for (const SpringLink& s : system.springs) {
    const Vec3d turn = ways.way[s.node_b] - ways.way[s.node_a];
    const Vec3d span = ways.start[s.node_b] - ways.start[s.node_a] + turn;
    const spring::Pull pull = spring::pull(span, turn / dt, s.law(), s.damping);
    pulls[s.node_a] += pull.tension * pull.direction;
    pulls[s.node_b] -= pull.tension * pull.direction;
  }
}

void add_membranes(const FabricCloth& cloth, const Ways& ways, double dt, std::vector<Vec3d>& pulls) {
  const membrane::Membranes& membranes = cloth.membranes;
  for (std::size_t t = 0; t < membranes.triangles.size(); ++t) {
    membrane::Corners places, starts;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t node = cloth.first + membranes.triangles[t][i];
      places[i] = ways.place(node);
      starts[i] = ways.start[node];
    }
    const membrane::Rest& rest = membranes.rests[t];
    const membrane::Corners forces =
        membrane::forces(rest, bounded_yarns::stress(membranes.law, membrane::deformation(rest, places),
                                                     membrane::deformation(rest, starts), 1 / dt));
    for (std::size_t i = 0; i < 3; ++i) pulls[cloth.first + membranes.triangles[t][i]] += forces[i];
  }
}

}  // namespace

std::vector<Vec3d> ProjectiveDynamicsStepper::pulls(const MassSpringSystem& system, const Ways& ways,
                                                    double dt) {
  std::vector<Vec3d> pulls(ways.way.size());
  add_springs(system, ways, dt, pulls);
  for (std::size_t f = 0; f < fabrics_.size(); ++f) {
    add_membranes(system.fabrics[f], ways, dt, pulls);
    const Fabric& cloth = fabrics_[f];
    for (const NodePair& pair : cloth.pairs) {
      const std::size_t a = cloth.first + pair.a, b = cloth.first + pair.b;
      const Vec3d span = ways.place(b) - ways.place(a);
      pulls[a] += pair.bending * span;
      pulls[b] -= pair.bending * span;
    }
  }
  for (std::size_t s = 0; s < solids_.size(); ++s) solids_[s].begin(system.solids[s], ways, dt, pulls);
  return pulls;
}

std::vector<Vec3d> ProjectiveDynamicsStepper::pulls_of_change(const MassSpringSystem& system,
                                                              const std::vector<Vec3d>& change,
                                                              double dt) const {
  std::vector<Vec3d> pulls(change.size());
  const auto add = [&](std::size_t a, std::size_t b, double weight) {
    const Vec3d pull = weight * (change[b] - change[a]);
    pulls[a] += pull;
    pulls[b] -= pull;
  };
  for (const SpringLink& s : system.springs) add(s.node_a, s.node_b, s.stiffness + s.damping / dt);
  for (const Fabric& cloth : fabrics_)
    for (const NodePair& pair : cloth.pairs)
      add(cloth.first + pair.a, cloth.first + pair.b, pair.pull + pair.damping / dt);
  for (std::size_t s = 0; s < solids_.size(); ++s) solids_[s].add_pulls_of(system.solids[s], change, pulls);
  return pulls;
}

ProjectiveDynamicsStepper::ProjectiveDynamicsStepper(const Model& model, double step,
                                                     std::uint32_t iterations)
    : pieces_(free_pieces(model, PiecesOf::Elements)), look_back_(model.rest_position.size()) {
  double most = 0;
  for (const Body& cloth : model.bodies) {
    const ClothRates rates = cloth_rates(model, cloth);
    rates_of_.insert(rates_of_.end(), cloth.vertex_count, rates);
    most = std::max(most, rates.at(step));
    if (cloth.fabric) fabrics_.push_back({cloth.first_vertex, fabric_node_pairs(model, cloth)});
    if (cloth.solid) solids_.emplace_back();
  }
  relaxation_ = make_relaxation(most, iterations);
}

void ProjectiveDynamicsStepper::advance(const Substep& substep) {
  const double dt = substep.dt;
  std::vector<Vec3d> aim;
  Ways ways = holds_.begin(substep, look_back_, aim);
  std::vector<Vec3d> left(aim.size()), change(aim.size());
  const auto relax = [&](std::size_t node, double weight) {
    const Vec3d before = ways.way[node];
    const Vec3d free =
        before + weight * relaxation_.gain(rates_of_[node].at(dt)) * left[node] + (weight - 1) * change[node];
    const bool may_hold = holds_[node] && ways.inverse_mass[node] > 0;
    ways.way[node] = may_hold ? holds_[node]->descend({free, Sym3::identity(1)}) : free;
    change[node] = ways.way[node] - before;
  };
  for (const std::vector<double>& weights : relaxation_.cycles) {
    const std::vector<Vec3d> force = pulls(substep.system, ways, dt);
    for (std::size_t node = 0; node < aim.size(); ++node) {
      left[node] = {};
      if (ways.inverse_mass[node] > 0)
        left[node] = aim[node] - ways.way[node] + dt * dt * ways.inverse_mass[node] * force[node];
      relax(node, 1);
    }
    for (const double weight : weights) {
      const std::vector<Vec3d> more = pulls_of_change(substep.system, change, dt);
      for (std::size_t node = 0; node < aim.size(); ++node) {
        left[node] += dt * dt * ways.inverse_mass[node] * more[node] - change[node];
        relax(node, weight);
      }
    }
  }
  keep_momentum(
      pieces_, aim, [&](std::uint32_t node) { return !holds_.bears(node); }, ways);
  ways.end(substep);
  holds_.end(substep, ways.way);
}

}  // namespace weft::reference
