#include "element/reference/motion.hpp"

#include <cassert>
#include <utility>

#include "element/reference/newton.hpp"

namespace weft::reference {

struct Motion::Content {
  SheetEnergy energy;
  SheetState state, before;
  Scheme scheme;
  NewtonLimits limits;
  double last = 0;  // the step from `before` [s]; 0: there was none
  Newton newton;

  Content(Sheet sheet, SheetState start, Scheme by, NewtonLimits most)
      : energy(std::move(sheet)), state(std::move(start)), scheme(by), limits(most), newton(energy) {
    assert(state.position.size() == energy.mass().size() && state.velocity.size() == energy.mass().size());
    place_held(state);
  }

  void place_held(SheetState& at) const {
    for (std::size_t v = 0; v < at.position.size(); ++v) {
      if (!energy.sheet().is_held(v)) continue;
      const Placed placed = energy.sheet().placed(v, at.time);
      at.position[v] = placed.position;
      at.velocity[v] = placed.velocity;
    }
  }

  /// To the middle by backward Euler, and as far again: x' = 2 x_m - x, v' = 2 v_m - v.
  Result<NewtonReport> midpoint_step(double dt, SheetState& next) {
    const Increment increment{dt / 2, state.position, state.velocity};
    std::vector<Vec3d> middle(next.position.size());
    for (std::size_t v = 0; v < middle.size(); ++v)
      middle[v] = energy.sheet().is_held(v) ? 0.5 * (state.position[v] + next.position[v])
                                            : state.position[v] + dt / 2 * state.velocity[v];
    WEFT_TRY(report, newton.solve(increment, limits, middle));
    for (std::size_t v = 0; v < middle.size(); ++v) {
      if (energy.sheet().is_held(v)) continue;
      const Vec3d way = middle[v] - state.position[v];
      next.position[v] = state.position[v] + 2 * way;
      next.velocity[v] = 4 / dt * way - state.velocity[v];
    }
    return report;
  }

  /// x' = x + c (x - x before) + h v', v' the same of v and a, for a step that is r times the one before it:
  /// h = dt (1 + r)/(1 + 2 r), c = r²/(1 + 2 r). The first step, backward Euler, is that with r = 0; its error is of
  /// the second order, and made once. (A first midpoint step gave a sheet that tumbles an eighth of its energy, where
  /// it turned by 0.3 rad.)
  Result<NewtonReport> bdf2_step(double dt, SheetState& next) {
    const double r = last > 0 ? dt / last : 0, c = r * r / (1 + 2 * r);
    Increment increment{dt * (1 + r) / (1 + 2 * r), state.position, state.velocity};
    for (std::size_t v = 0; v < next.position.size(); ++v) {
      if (r > 0) {
        increment.from[v] += c * (state.position[v] - before.position[v]);
        increment.v[v] += c * (state.velocity[v] - before.velocity[v]);
      }
      if (!energy.sheet().is_held(v)) next.position[v] = state.position[v] + dt * state.velocity[v];
    }
    WEFT_TRY(report, newton.solve(increment, limits, next.position));
    for (std::size_t v = 0; v < next.position.size(); ++v)
      if (!energy.sheet().is_held(v)) next.velocity[v] = (next.position[v] - increment.from[v]) / increment.h;
    return report;
  }
};

Motion::Motion(Sheet sheet, SheetState start, Scheme scheme, NewtonLimits limits)
    : content_(std::make_unique<Content>(std::move(sheet), std::move(start), scheme, limits)) {}
Motion::Motion(Motion&&) noexcept = default;
Motion::~Motion() = default;

Result<NewtonReport> Motion::advance(double dt) {
  Content& c = *content_;
  SheetState next = c.state;
  next.time += dt;
  c.place_held(next);
  WEFT_TRY(report, c.scheme == Scheme::Midpoint ? c.midpoint_step(dt, next) : c.bdf2_step(dt, next));
  c.before = std::exchange(c.state, std::move(next));
  c.last = dt;
  return report;
}

const SheetEnergy& Motion::energy() const { return content_->energy; }
const SheetState& Motion::state() const { return content_->state; }
double Motion::total_energy() const {
  return energy().potential(state().position) + energy().kinetic(state().velocity);
}

}  // namespace weft::reference
