#include "method/gas_reference.hpp"

namespace weft::reference {

double EnclosedGas::volume(std::span<const Vec3d> places) const {
  return mesh::signed_volume(triangles, places);
}

void EnclosedGas::add_forces(std::span<const Vec3d> places, std::span<Vec3d> forces) const {
  const double sixth = law.gauge(volume(places)) / 6;
  for (const auto& [a, b, c] : triangles) {
    const Vec3d force = sixth * cross(places[b] - places[a], places[c] - places[a]);
    for (const std::uint32_t node : {a, b, c}) forces[node] += force;
  }
}

std::vector<EnclosedGas> enclosed_gases(const Model& model) {
  std::vector<EnclosedGas> all;
  for (const Body& body : model.bodies) {
    if (!body.gas) continue;
    const auto first = model.triangles.begin() + body.first_triangle;
    all.push_back({{first, first + body.triangle_count}, *body.gas});
  }
  return all;
}

}  // namespace weft::reference
