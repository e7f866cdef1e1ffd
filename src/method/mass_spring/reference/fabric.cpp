#include "method/mass_spring/reference/fabric.hpp"

#include "model/fabric.hpp"

namespace weft::reference {
namespace {

membrane::Corners corners_at(const mesh::Triangle& nodes, std::span<const Vec3d> x) {
  return {x[nodes[0]], x[nodes[1]], x[nodes[2]]};
}

/// How fast each hinge bends [rad/s].
std::vector<double> bend_rates(const hinge::Plate& plate, std::span<const Vec3d> position,
                               std::span<const Vec3d> velocity) {
  std::vector<double> rates;
  rates.reserve(plate.hinges.size());
  for (const hinge::Hinge& hinge : plate.hinges) {
    const hinge::Corners slope = hinge::angle_slope(hinge::corners_of(hinge, position)),
                         speed = hinge::corners_of(hinge, velocity);
    double rate = 0;
    for (std::size_t i = 0; i < 4; ++i) rate += dot(slope[i], speed[i]);
    rates.push_back(rate);
  }
  return rates;
}

}  // namespace

void FabricCloth::add_forces(std::span<const Vec3d> position, std::span<const Vec3d> velocity,
                             std::span<Vec3d> forces) const {
  const auto x = position.subspan(first, count), v = velocity.subspan(first, count);
  const auto own = forces.subspan(first, count);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const membrane::Axes f = membrane::deformation(rest[t], corners_at(triangles[t], x)),
                         rate = membrane::deformation(rest[t], corners_at(triangles[t], v));
    const membrane::Axes elastic = membrane::stress(law, f), damping = membrane::damping_stress(law, f, rate);
    const membrane::Corners corner_forces =
        membrane::forces(rest[t], {elastic.warp + damping.warp, elastic.weft + damping.weft});
    for (std::size_t i = 0; i < 3; ++i) own[triangles[t][i]] += corner_forces[i];
  }
  std::vector<double> bends = hinge::bends(plate, x);
  const std::vector<double> rates = bend_rates(plate, x, v);
  for (std::size_t h = 0; h < bends.size(); ++h) bends[h] += law.delay * rates[h];
  hinge::add_forces(plate, hinge::moments(plate, bends), x, own);
}

double FabricCloth::energy(std::span<const Vec3d> position) const {
  const auto x = position.subspan(first, count);
  double sum = hinge::energy(plate, hinge::bends(plate, x));
  for (std::size_t t = 0; t < triangles.size(); ++t)
    sum += rest[t].area * membrane::energy(law, membrane::deformation(rest[t], corners_at(triangles[t], x)));
  return sum;
}

std::vector<FabricCloth> fabric_cloths(const Model& model) {
  std::vector<FabricCloth> all;
  for (const Body& body : model.bodies) {
    if (!body.fabric) continue;
    FabricSheet sheet = fabric_sheet(model, body);
    FabricCloth cloth{body.first_vertex,          body.vertex_count,    sheet.triangles, {},
                      membrane_law(*body.fabric), plate_of(model, body)};
    for (const mesh::Triangle& t : sheet.triangles)
      cloth.rest.push_back(membrane::Rest::of(places_of(corners_at(t, sheet.position), sheet.warp)));
    all.push_back(std::move(cloth));
  }
  return all;
}

}  // namespace weft::reference
