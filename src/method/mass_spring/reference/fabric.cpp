#include "method/mass_spring/reference/fabric.hpp"

#include "model/fabric.hpp"

namespace weft::reference {

void FabricCloth::add_forces(std::span<const Vec3d> position, std::span<const Vec3d> velocity,
                             std::span<Vec3d> forces) const {
  const auto x = position.subspan(first, count), v = velocity.subspan(first, count);
  const auto own = forces.subspan(first, count);
  membranes.add_forces(x, own);
  membranes.add_damping_forces(x, v, own);
  std::vector<double> bends = hinge::bends(plate, x);
  const std::vector<double> rates = hinge::bend_rates(plate, x, v);
  for (std::size_t h = 0; h < bends.size(); ++h) bends[h] += membranes.law.delay * rates[h];
  hinge::add_forces(plate, hinge::moments(plate, bends, creases), x, own);
  for (const Cord& limit : limits) {
    const auto [tension, direction] = spring::pull(x[limit.b] - x[limit.a], {}, law_of(limit), 0);
    own[limit.a] += tension * direction;
    own[limit.b] -= tension * direction;
  }
}

void FabricCloth::set_creases(std::span<const Vec4f> words) {
  for (std::size_t f = 0; f < creases.size(); ++f) {
    const Vec4f& word = words[first_crease + f];
    creases[f] = {word.xyz().to<double>(), static_cast<double>(word.w)};
  }
}

void FabricCloth::yield(std::span<const Vec3d> position) {
  if (yields) hinge::yield(plate, *yields, hinge::bends(plate, position.subspan(first, count)), creases);
}

double FabricCloth::stretching(std::span<const Vec3d> position) const {
  const auto x = position.subspan(first, count);
  double sum = membranes.energy(x);
  for (const Cord& limit : limits) sum += spring::energy(x[limit.b] - x[limit.a], law_of(limit));
  return sum;
}

double FabricCloth::bending(std::span<const Vec3d> position) const {
  return hinge::energy(plate, hinge::bends(plate, position.subspan(first, count)), creases);
}

std::vector<FabricCloth> fabric_cloths(const Model& model) {
  std::vector<FabricCloth> all;
  for (const Body& body : model.bodies) {
    if (!body.fabric) continue;
    const std::optional<hinge::Yield> yields = yield_law(*body.fabric);
    all.push_back({body.first_vertex, body.vertex_count,
                   membrane::Membranes::of(fabric_sheet(model, body).rest(), membrane_law(*body.fabric)),
                   model.plate(body), limit_cords(model, body), yields,
                   std::vector<hinge::Crease>(yields ? body.triangle_count : 0), first_crease(model, body)});
  }
  return all;
}

}  // namespace weft::reference
