#include "element/tet/tets.hpp"

namespace weft::tet {

Tets Tets::of(std::span<const Vec3d> rest_position, std::span<const mesh::Tet> tets, const Law& law) {
  Tets made{{tets.begin(), tets.end()}, {}, law};
  made.rests.reserve(made.tets.size());
  for (std::size_t t = 0; t < made.tets.size(); ++t)
    made.rests.push_back(Rest::of(made.corners(t, rest_position)));
  return made;
}

double Tets::energy(std::span<const Vec3d> x) const {
  double sum = 0;
  for (std::size_t t = 0; t < rests.size(); ++t) sum += rests[t].volume * tet::energy(law, deformation(t, x));
  return sum;
}

void Tets::add_forces(std::span<const Vec3d> x, std::span<Vec3d> forces) const {
  for (std::size_t t = 0; t < rests.size(); ++t) add(t, stress(law, deformation(t, x)), forces);
}

void Tets::add_damping_forces(std::span<const Vec3d> x, std::span<const Vec3d> velocity,
                              std::span<Vec3d> forces) const {
  if (law.delay == 0) return;
  for (std::size_t t = 0; t < rests.size(); ++t)
    add(t, damping_stress(law, deformation(t, x), deformation(t, velocity)), forces);
}

void Tets::add(std::size_t tet, const Mat3& stress, std::span<Vec3d> forces) const {
  const Corners own = tet::forces(rests[tet], stress);
  for (std::size_t k = 0; k < 4; ++k) forces[tets[tet][k]] += own[k];
}

ElementTable build_tets(const Tets& tets, std::uint32_t first) {
  ElementTable table{ElementKind::Tet, {}, {}, {}};
  table.nodes.reserve(4 * tets.tets.size());
  table.rest.reserve(10 * tets.tets.size());
  table.material.reserve(3 * tets.tets.size());
  const auto& [energy, mu, lambda, delay] = tets.law;
  for (std::size_t t = 0; t < tets.tets.size(); ++t) {
    for (const std::uint32_t node : tets.tets[t]) table.nodes.push_back(first + node);
    const Rest& rest = tets.rests[t];
    for (std::size_t k = 1; k < 4; ++k)
      for (int axis = 0; axis < 3; ++axis) table.rest.push_back(static_cast<float>(rest.slope[k][axis]));
    table.rest.push_back(static_cast<float>(rest.volume));
    for (const double number : {mu, lambda, delay}) table.material.push_back(static_cast<float>(number));
  }
  return table;
}

}  // namespace weft::tet
