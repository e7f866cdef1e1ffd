// A spring in the linear system of a substep, in double. Source: docs/solvers/multigrid.md, equations 5 and 6.
#pragma once

#include <algorithm>
#include <cmath>

#include "element/spring/law.hpp"
#include "method/multigrid/lead.hpp"
#include "method/multigrid/reference/implicit_step.hpp"

namespace weft::reference {

struct SpringTerms {
  Vec3d force;                        // on the first node, at place + start [N]
  Vec3d direction;                    // n, in which it is linearised
  double stretch = 0;                 // β of the matrix
  double stiffness = 0, damping = 0;  // with what a strain limit adds; by the step [N/m]

  /// Its part of the matrix; or that of another spring of Hooke's law that lies as this one does, and damps.
  Sym3 block() const { return as_stiff(stiffness, damping); }
  Sym3 as_stiff(double other, double other_damping) const {
    return Sym3::outer(direction, other * (1 - stretch) + other_damping) + Sym3::identity(other * stretch);
  }
};

/// β of the matrix with contact, equation (6a): what presses here, or where the unknown starts, resists across by the
/// force that it has in the residual. `longer`: what the start of the unknown adds to its length [m].
inline double held_across(double stretch, double length, double rest_length, double longer) {
  const double pressed = rest_length - length;  // [m]
  if (std::max(pressed, pressed - longer) <= 0) return stretch;
  return std::min(1.0, std::abs(pressed - longer) / length);
}

/// Between nodes a and b of the cloth. `rate`: of velocities by places [1/s].
inline SpringTerms spring_terms(const spring::Law& all, double damped, const StepStart& step, std::size_t a,
                                std::size_t b, double rate) {
  const Vec3d span = step.place[b] - step.place[a], step_of_span = step.start[b] - step.start[a];
  const double square = std::max(dot(span, span), spring::kMinLength * spring::kMinLength);
  const double lead = step.leads ? multigrid::lead_of(dot(step_of_span, step_of_span) / square) : 0;
  const Vec3d at = span + lead * step_of_span;
  if (length(at) < spring::kMinLength) return {};
  const spring::Law law = all.at(std::max(length(span), length(at)));  // long in either, it is
  const auto [tension, n] = spring::pull(at, {}, law, 0);
  SpringTerms terms{{}, n, std::max(0.0, 1 - law.rest_length / length(at)), law.stiffness, damped * rate};
  // Damping acts along the spring as it will be: along n it would be of first order in the step.
  const Vec3d later = step.leads ? at : span + step_of_span;
  const Vec3d damping = Sym3::outer(later / std::max(length(later), spring::kMinLength), damped) *
                        (step.start_velocity[b] - step.start_velocity[a]);
  terms.force = tension * n + damping + terms.as_stiff(terms.stiffness, 0) * ((1 - lead) * step_of_span);
  if (!step.leads)
    terms.stretch = held_across(terms.stretch, length(at), law.rest_length, dot(n, step_of_span));
  return terms;
}

}  // namespace weft::reference
