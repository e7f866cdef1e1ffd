#include "model/panels.hpp"

#include <span>

namespace weft {
namespace {

Vec3d warp_of(const scene::Cloth& cloth, const scene::Panel& panel, std::span<const Vec3d> places) {
  if (panel.grid) return places[1] - places[0];
  const auto placed = [&](const Vec3d& point) {
    return scene::transformed(cloth.transform, scene::transformed(panel.transform, point));
  };
  return placed(cloth.fabric->warp_direction) - placed({});
}

}  // namespace

void add_warps(Model& model, const scene::Scene& scene, const Assets& assets) {
  for (std::size_t c = 0; c < scene.cloths.size(); ++c) {
    const scene::Cloth& cloth = scene.cloths[c];
    if (!cloth.fabric || cloth.panels.empty()) continue;
    Body& body = model.bodies[c];
    const auto places = std::span(model.rest_position).subspan(body.first_vertex, body.vertex_count);
    std::vector<Vec3d> of_nodes;  // of the panel of each
    for (std::size_t p = 0; p < cloth.panels.size(); ++p) {
      const Vec3d warp = warp_of(cloth, cloth.panels[p], places.subspan(of_nodes.size()));
      of_nodes.insert(of_nodes.end(), assets.panels[c][p], warp);
    }
    for (const mesh::Triangle& triangle : own_triangles(model, body))
      body.warps.push_back(of_nodes[triangle[0]]);
  }
}

}  // namespace weft
