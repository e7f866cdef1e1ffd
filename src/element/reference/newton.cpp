#include "element/reference/newton.hpp"

#include <algorithm>
#include <cmath>

namespace weft::reference {

Newton::Newton(const SheetEnergy& energy)
    : energy_(energy), unknowns_(energy.sheet()), matrix_(energy, unknowns_) {}

/// Whether the matrix is positive definite.
bool Newton::factor(const Matrix& matrix) {
  if (analysed_ != matrix.nonZeros()) factored_.analyzePattern(matrix);
  analysed_ = matrix.nonZeros();
  factored_.factorize(matrix);
  return factored_.info() == Eigen::Success && factored_.vectorD().minCoeff() > 0;
}

std::vector<Vec3d> Newton::velocities(const Increment& increment, Places x) const {
  std::vector<Vec3d> all(x.size());
  for (std::size_t v = 0; v < x.size(); ++v) all[v] = (x[v] - increment.from[v]) / increment.h;
  return all;
}

std::vector<Vec3d> Newton::forces(const Increment& increment, Places x) const {
  std::vector<Vec3d> all = energy_.forces(x);
  if (increment.h == 0) return all;
  const std::vector<Vec3d> velocity = velocities(increment, x), damping = energy_.damping_forces(x, velocity);
  for (std::size_t v = 0; v < x.size(); ++v)
    all[v] += damping[v] - energy_.mass()[v] * ((velocity[v] - increment.v[v]) / increment.h +
                                                energy_.sheet().drag * velocity[v]);
  return all;
}

double Newton::largest(std::span<const Vec3d> forces) const {
  double most = 0;
  for (std::size_t v = 0; v < forces.size(); ++v)
    if (unknowns_.of(v) >= 0) {
      const double left = length(forces[v]) / energy_.mass()[v];
      if (left > most || std::isnan(left)) most = left;
    }
  return most;
}

/// What the step makes least. Damping has a potential only while the strains' slopes do not change: they are those of
/// `damping_at`, the last iterate, where the slope of all this is `forces`.
double Newton::value(const Increment& increment, Places x, Places damping_at) const {
  double sum = energy_.potential(x);
  if (increment.h == 0) return sum;
  const std::vector<Vec3d> velocity = velocities(increment, x),
                           damping = energy_.damping_forces(damping_at, velocity);
  for (std::size_t v = 0; v < x.size(); ++v) {
    const Vec3d gain = velocity[v] - increment.v[v];
    sum += energy_.mass()[v] / 2 *
           (dot(gain, gain) + increment.h * energy_.sheet().drag * dot(velocity[v], velocity[v]));
    sum -= increment.h / 2 * dot(damping[v], velocity[v]);
  }
  return sum;
}

/// As far along a way as the value falls by a part of what its slope promises (Armijo 1966). Where roundings hide that
/// fall, the whole way counts if it leaves less force.
bool Newton::go(const Increment& increment, const Eigen::VectorXd& way, const Eigen::VectorXd& force,
                std::vector<Vec3d>& x) const {
  constexpr double kPart = 1e-4, kLeast = 1e-9, kRounding = 1e-11;
  const double before = value(increment, x, x), promised = way.dot(force);
  if (!(promised > 0)) return false;
  if (promised < kRounding * std::abs(before)) {
    std::vector<Vec3d> place = unknowns_.moved(x, way);
    if (!(largest(forces(increment, place)) < largest(forces(increment, x)))) return false;
    x = std::move(place);
    return true;
  }
  for (double part = 1; part > kLeast; part /= 2) {
    std::vector<Vec3d> place = unknowns_.moved(x, part * way);
    if (!(before - value(increment, place, x) >= kPart * part * promised)) continue;
    x = std::move(place);
    return true;
  }
  return false;
}

/// One step with this matrix; false if that leads nowhere.
bool Newton::step(const Increment& increment, Curvature curvature, const Eigen::VectorXd& force,
                  std::vector<Vec3d>& x) {
  const double rate = increment.h > 0 ? 1 / increment.h : 0;
  const double inertia = rate * (rate + energy_.sheet().drag);
  if (curvature == Curvature::Exact)
    return factor(matrix_.hessian(x, curvature, inertia, rate)) &&
           go(increment, factored_.solve(force), force, x);
  // Cloth without tension and mass has mechanisms: a matrix that is singular gets more inertia (Levenberg 1944).
  for (double more = 0; more < 1e12; more = std::max(1e-3, 100 * more))
    if (factor(matrix_.hessian(x, curvature, inertia + more, rate)) &&
        go(increment, factored_.solve(force), force, x))
      return true;
  return false;
}

Result<NewtonReport> Newton::solve(const Increment& increment, const NewtonLimits& limits,
                                   std::vector<Vec3d>& x) {
  NewtonReport report;
  for (;; ++report.steps) {
    const std::vector<Vec3d> left = forces(increment, x);
    report.residual = largest(left);
    if (report.residual <= limits.residual) return report;
    const Eigen::VectorXd force = unknowns_.gathered(left);
    if (report.steps == limits.steps) break;
    if (step(increment, Curvature::Exact, force, x)) continue;
    ++report.positive_steps;
    if (!step(increment, Curvature::Positive, force, x)) break;
  }
  return make_error(ErrorKind::Diverged,
                    "After %d steps Newton's method leaves a residual of %.3g m/s², above %.3g m/s².",
                    report.steps, report.residual, limits.residual);
}

bool Newton::stable(Places x) { return factor(matrix_.hessian(x, Curvature::Exact)); }

}  // namespace weft::reference
