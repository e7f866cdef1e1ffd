#include "element/reference/sheet_energy.hpp"

#include <cassert>

namespace weft::reference {

SheetEnergy::SheetEnergy(Sheet sheet) : sheet_(std::move(sheet)), mass_(sheet_.rest.size()) {
  assert(sheet_.held.empty() || sheet_.held.size() == sheet_.rest.size());
  assert(sheet_.load.empty() || sheet_.load.size() == sheet_.rest.size());
  const RestSheet rest{sheet_.rest, sheet_.triangles, sheet_.warp, sheet_.held};
  plate_ = hinge::build_plate(rest, sheet_.bending);
  membranes_ = membrane::Membranes::of(rest, sheet_.membrane);
  for (std::size_t t = 0; t < sheet_.triangles.size(); ++t)
    for (const std::uint32_t node : sheet_.triangles[t])
      mass_[node] += sheet_.density * membranes_.rests[t].area / 3;
}

double SheetEnergy::bending(Places x) const { return hinge::energy(plate_, hinge::bends(plate_, x)); }

double SheetEnergy::potential(Places x) const {
  double sum = stretching(x) + bending(x);
  for (std::size_t v = 0; v < x.size(); ++v) {
    const Vec3d pull = mass_[v] * sheet_.gravity + (sheet_.load.empty() ? Vec3d{} : sheet_.load[v]);
    sum -= dot(pull, x[v] - sheet_.rest[v]);
  }
  return sum;
}

double SheetEnergy::kinetic(std::span<const Vec3d> velocity) const {
  double sum = 0;
  for (std::size_t v = 0; v < velocity.size(); ++v) sum += mass_[v] / 2 * dot(velocity[v], velocity[v]);
  return sum;
}

std::vector<Vec3d> SheetEnergy::forces(Places x) const {
  std::vector<Vec3d> all(x.size());
  membranes_.add_forces(x, all);
  hinge::add_forces(plate_, hinge::moments(plate_, hinge::bends(plate_, x)), x, all);
  for (std::size_t v = 0; v < x.size(); ++v)
    all[v] += mass_[v] * sheet_.gravity + (sheet_.load.empty() ? Vec3d{} : sheet_.load[v]);
  return all;
}

std::vector<Vec3d> SheetEnergy::damping_forces(Places x, std::span<const Vec3d> velocity) const {
  std::vector<Vec3d> all(x.size());
  membranes_.add_damping_forces(x, velocity, all);
  return all;
}

}  // namespace weft::reference
