#include "model/fabric.hpp"

namespace weft {

Moduli membrane_moduli(const scene::Fabric& fabric) {
  return {fabric.warp, fabric.weft, fabric.poisson, fabric.shear};
}

membrane::Law membrane_law(const scene::Fabric& fabric) {
  membrane::Energy energy = membrane::Energy::Yarn;
  if (fabric.energy == scene::FabricEnergy::Green) energy = membrane::Energy::Green;
  if (fabric.energy == scene::FabricEnergy::NeoHookean) energy = membrane::Energy::NeoHookean;
  return {energy, Stiffness::of(membrane_moduli(fabric)), fabric.damping};
}

Stiffness bending_law(const scene::Fabric& fabric) {
  return {fabric.bending_warp, 0, fabric.bending_weft, fabric.bending_twist};
}

std::optional<hinge::Yield> yield_law(const scene::Fabric& fabric) {
  if (!fabric.plastic) return std::nullopt;
  return hinge::Yield{fabric.plastic->yield_curvature, fabric.plastic->hardening};
}

static std::uint32_t creases_before(const Model& model, const Body* end) {
  std::uint32_t sum = 0;
  for (const Body* body = model.bodies.data(); body != end; ++body)
    if (body->fabric && body->fabric->plastic) sum += body->triangle_count;
  return sum;
}

std::uint32_t crease_count(const Model& model) {
  return creases_before(model, model.bodies.data() + model.bodies.size());
}

std::uint32_t first_crease(const Model& model, const Body& body) { return creases_before(model, &body); }

FabricSheet fabric_sheet(const Model& model, const Body& body) {
  FabricSheet sheet;
  sheet.warp = body.warp;
  sheet.warps = body.warps;
  for (std::uint32_t v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
    if (!body.pattern) sheet.position.push_back(model.rest_position[v]);
    sheet.held.push_back(model.kinematic(v) ? 1 : 0);
  }
  sheet.triangles = own_triangles(model, body);
  if (body.pattern) {
    sheet.position = body.pattern->position;
    sheet.cut = body.pattern->triangles;
  }
  return sheet;
}

ElementTable hinge_table(const hinge::Plate& plate, std::uint32_t first) {
  ElementTable table{ElementKind::Hinge, {}, {}, {}};
  for (const hinge::Hinge& hinge : plate.hinges) {
    for (const std::uint32_t node : hinge.nodes) table.nodes.push_back(first + node);
    table.rest.push_back(static_cast<float>(hinge.rest_angle));
  }
  return table;
}

}  // namespace weft
