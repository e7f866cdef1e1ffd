#include "method/projection/reference/projection_stepper.hpp"

#include "element/spring/law.hpp"
#include "method/reference_ways.hpp"

namespace weft::reference {
namespace {

/// Equations (3) to (5); `multiplier` is the spring's.
void project(Ways& ways, const SpringLink& s, double dt, double& multiplier) {
  const double w_a = ways.inverse_mass[s.node_a], w_b = ways.inverse_mass[s.node_b];
  const Vec3d turn = ways.way[s.node_b] - ways.way[s.node_a];
  const Vec3d span = ways.start[s.node_b] - ways.start[s.node_a] + turn;
  const spring::Pull pull = spring::pull(span, turn / dt, s.law(), s.damping);
  const double resistance = (dt * dt * s.stiffness + dt * s.damping) * (w_a + w_b);
  const double change = -(dt * dt * pull.tension + multiplier) / (1 + resistance);
  multiplier += change;
  ways.way[s.node_a] -= w_a * change * pull.direction;
  ways.way[s.node_b] += w_b * change * pull.direction;
}

}  // namespace

ProjectionStepper::ProjectionStepper(const Model& model, std::uint32_t iterations, Multipliers multipliers)
    : model_(model), iterations_(iterations), multipliers_(multipliers), tethers_(tethers_of(model)) {
  for (const Body& body : model.bodies) {
    if (body.fabric) fabrics_.emplace_back(model, body, multipliers);
    if (body.solid) solids_.emplace_back(model, body, multipliers);
  }
}

/// Equation (14a): the tethers `first` to before `end`.
double ProjectionStepper::lengthening(const Ways& ways, std::uint32_t first, std::uint32_t end) const {
  double longer = 1;
  for (std::uint32_t k = first + 1; k < end; ++k)
    for (std::uint32_t m = first; m < k; ++m) {
      const Tether &a = tethers_.tethers[m], &b = tethers_.tethers[k];
      const double both = double{a.length} + double{b.length};
      if (both > 0) longer = std::max(longer, length(ways.place(b.to) - ways.place(a.to)) / both);
    }
  return longer;
}

/// Equation (14).
void ProjectionStepper::keep_tethers(Ways& ways) const {
  for (std::size_t node = 0; node < ways.way.size(); ++node) {
    if (ways.inverse_mass[node] == 0) continue;
    const std::uint32_t first = tethers_.starts[node], end = tethers_.starts[node + 1];
    const double longer = lengthening(ways, first, end);
    for (std::uint32_t k = first; k < end; ++k) {
      const Tether& tether = tethers_.tethers[k];
      const double longest = longer * tether.length;
      const Vec3d span = ways.place(node) - ways.place(tether.to);
      const double far = length(span);
      if (far > longest) ways.way[node] -= (1 - longest / far) * span;
    }
  }
}

void ProjectionStepper::project_holds(Ways& ways) {
  for (std::size_t node = 0; node < ways.way.size(); ++node)
    if (holds_[node] && ways.inverse_mass[node] > 0) ways.way[node] = holds_[node]->project(ways.way[node]);
}

void ProjectionStepper::advance(const Substep& substep) {
  MassSpringSystem& system = substep.system;
  const double dt = substep.dt;
  yield(system);
  holds_.take(substep);
  Ways ways = Ways::begin(substep);
  const Colors& colors = model_.colors(ElementKind::Spring);
  std::vector<double> multipliers(system.springs.size(), 0.0);
  for (FabricProjection& fabric : fabrics_) fabric.begin();
  for (SolidProjection& solid : solids_) solid.begin();
  for (std::uint32_t sweep = 0; sweep < iterations_; ++sweep) {
    if (multipliers_ == Multipliers::Forgotten) multipliers.assign(multipliers.size(), 0.0);
    for (const std::uint32_t spring : colors.elements)
      project(ways, system.springs[spring], dt, multipliers[spring]);
    for (std::size_t cloth = 0; cloth < fabrics_.size(); ++cloth)
      fabrics_[cloth].sweep(ways, system.fabrics[cloth], dt);
    for (std::size_t body = 0; body < solids_.size(); ++body)
      solids_[body].sweep(ways, system.solids[body], dt);
    keep_tethers(ways);
    project_holds(ways);
  }
  ways.end(substep);
  holds_.end(substep, ways.way);
}

}  // namespace weft::reference
