#include "scene/difference.hpp"

#include "base/json.hpp"

namespace weft::scene {
namespace {

const char* grid_difference(const std::optional<GridShape>& a, const std::optional<GridShape>& b) {
  if (!a && !b) return nullptr;
  if (!a || !b || a->nx != b->nx || a->ny != b->ny) return "grid";
  if (a->width != b->width || a->height != b->height) return "size";
  if (a->plane != b->plane) return "plane";
  return a->bump == b->bump ? nullptr : "bump";
}

const char* solid_difference(const std::optional<Solid>& a, const std::optional<Solid>& b) {
  if (!a && !b) return nullptr;
  if (!a || !b || a->block.has_value() != b->block.has_value()) return "block";
  if (a->block && a->block->cells != b->block->cells) return "block";
  if (a->block && !(a->block->size == b->block->size)) return "size";
  if (a->tetrahedra != b->tetrahedra) return "tetrahedra";
  if (a->surface != b->surface) return "surface";
  if (a->cell != b->cell) return "cell";
  return *a == *b ? nullptr : "material";
}

const char* cloth_difference(const Cloth& a, const Cloth& b) {
  if (const char* key = solid_difference(a.solid, b.solid)) return key;
  if (const char* key = grid_difference(a.grid, b.grid)) return key;
  if (a.mesh != b.mesh) return "mesh";
  if (!(a.panels == b.panels)) return "panels";
  if (!(a.seams == b.seams)) return "seams";
  if (!(a.transform == b.transform)) return b.copy > 0 ? "copies" : "transform";  // the first's are equal
  if (a.density != b.density) return "density";
  if (a.node_mass != b.node_mass) return "node_mass";
  if (a.fabric != b.fabric) return "fabric";
  if (!(a.stiffness == b.stiffness)) return "stiffness";
  if (a.damping != b.damping) return "damping";
  if (a.friction != b.friction) return "friction";
  if (a.strain_limit != b.strain_limit) return "strain_limit";
  if (a.tethers != b.tethers) return "tethers";
  if (a.strength != b.strength) return "strength";
  if (a.pressure != b.pressure) return "pressure";
  if (!(a.pins == b.pins)) return "pins";
  if (!(a.motions == b.motions)) return "motions";
  if (!(a.attachments == b.attachments)) return "attachments";
  return a.grabs == b.grabs ? nullptr : "grabs";
}

bool differ(const Collider& running, Collider wanted) {
  set_material(wanted, material_of(running));
  return !(running == wanted);
}

}  // namespace

std::optional<std::string> fixed_difference(const Scene& running, const Scene& wanted) {
  if (running.time.frame != wanted.time.frame) return "time.frame";
  if (running.time.substeps != wanted.time.substeps) return "time.substeps";
  if (running.solver.kind != wanted.solver.kind) return "solver.kind";
  if (running.solver.forces != wanted.solver.forces) return "solver.forces";
  if (running.solver.iterations != wanted.solver.iterations) return "solver.iterations";
  if (running.solver.residual != wanted.solver.residual) return "solver.residual";
  if (running.contact.method != wanted.contact.method) return "contact.method";
  if (running.contact.thickness != wanted.contact.thickness) return "contact.thickness";
  if (running.contact.self != wanted.contact.self) return "contact.self";
  if (running.contact.restitution != wanted.contact.restitution) return "contact.restitution";
  if (running.air.has_value() != wanted.air.has_value()) return "air";
  if (running.cloths.size() != wanted.cloths.size()) return "cloths";
  for (std::size_t c = 0; c < running.cloths.size(); ++c)
    if (const char* key = cloth_difference(running.cloths[c], wanted.cloths[c]))
      return path_of_key(path_of(wanted.cloths[c]), key);
  if (running.colliders.size() != wanted.colliders.size()) return "colliders";
  for (std::size_t c = 0; c < running.colliders.size(); ++c)
    if (differ(running.colliders[c], wanted.colliders[c])) return path_of_index("colliders", c);
  if (running.render.subdivide != wanted.render.subdivide) return "render.subdivide";
  return std::nullopt;
}

}  // namespace weft::scene
