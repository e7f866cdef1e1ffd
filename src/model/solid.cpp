#include "model/solid.hpp"

#include <span>

namespace weft {

tet::Law tet_law(const scene::Solid& solid) {
  const tet::Energy energy =
      solid.energy == scene::SolidEnergy::Corotated ? tet::Energy::Corotated : tet::Energy::NeoHookean;
  return tet::Law::of(energy, solid.young, solid.poisson, solid.damping);
}

tet::Tets body_tets(const Model& model, const Body& body) {
  return tet::Tets::of(std::span(model.rest_position).subspan(body.first_vertex, body.vertex_count),
                       body.tets, tet_law(*body.solid));
}

}  // namespace weft
