#include "element/membrane/membranes.hpp"

namespace weft::membrane {

Membranes Membranes::of(const RestSheet& sheet, const Law& law) {
  Membranes made{{sheet.triangles.begin(), sheet.triangles.end()}, {}, law};
  made.rests.reserve(made.triangles.size());
  for (std::size_t t = 0; t < made.triangles.size(); ++t) made.rests.push_back(Rest::of(sheet.places(t)));
  return made;
}

double Membranes::energy(std::span<const Vec3d> x) const {
  double sum = 0;
  for (std::size_t t = 0; t < rests.size(); ++t)
    sum += rests[t].area * membrane::energy(law, deformation(t, x));
  return sum;
}

void Membranes::add_forces(std::span<const Vec3d> x, std::span<Vec3d> forces) const {
  for (std::size_t t = 0; t < rests.size(); ++t) add(t, stress(law, deformation(t, x)), forces);
}

void Membranes::add_damping_forces(std::span<const Vec3d> x, std::span<const Vec3d> velocity,
                                   std::span<Vec3d> forces) const {
  if (law.delay == 0) return;
  for (std::size_t t = 0; t < rests.size(); ++t)
    add(t, damping_stress(law, deformation(t, x), deformation(t, velocity)), forces);
}

void Membranes::add(std::size_t triangle, const Axes& stress, std::span<Vec3d> forces) const {
  const Corners own = membrane::forces(rests[triangle], stress);
  for (std::size_t i = 0; i < 3; ++i) forces[triangles[triangle][i]] += own[i];
}

}  // namespace weft::membrane
