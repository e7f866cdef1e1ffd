#include "method/mass_spring/reference/solid.hpp"

#include "model/solid.hpp"

namespace weft::reference {

void SolidBody::add_forces(std::span<const Vec3d> position, std::span<const Vec3d> velocity,
                           std::span<Vec3d> forces) const {
  const auto x = position.subspan(first, count), v = velocity.subspan(first, count);
  const auto own = forces.subspan(first, count);
  tets.add_forces(x, own);
  tets.add_damping_forces(x, v, own);
}

double SolidBody::energy(std::span<const Vec3d> position) const {
  return tets.energy(position.subspan(first, count));
}

std::vector<SolidBody> solid_bodies(const Model& model) {
  std::vector<SolidBody> all;
  for (const Body& body : model.bodies)
    if (body.solid) all.push_back({body.first_vertex, body.vertex_count, body_tets(model, body)});
  return all;
}

}  // namespace weft::reference
