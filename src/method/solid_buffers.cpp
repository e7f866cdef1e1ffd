#include "method/solid_buffers.hpp"

#include "element/incidence.hpp"
#include "element/tet/law.hpp"
#include "method/fabric_buffers.hpp"
#include "model/solid.hpp"

namespace weft {

std::vector<std::uint32_t> tet_corners_of_nodes(const Model& model, std::span<const Body> bodies) {
  std::vector<std::uint32_t> corners;
  for (const Body& body : bodies) {
    const std::vector<std::uint32_t>& own = model.elements(ElementKind::Tet, body).nodes;
    corners.insert(corners.end(), own.begin(), own.end());
  }
  const std::uint32_t first = bodies.front().first_vertex,
                      count = bodies.back().first_vertex + bodies.back().vertex_count - first;
  const mesh::Adjacency places = places_in(corners, first, count);
  return rows_then_entries(places.offsets, places.entries);
}

Result<SolidBuffers> SolidBuffers::create(gpu::Device& device, const Model& model, const Body& body,
                                          std::uint32_t first, std::uint32_t first_tet) {
  SolidBuffers made;
  const ElementTable& tets = model.elements(ElementKind::Tet, body);
  const tet::Law law = tet_law(*body.solid);
  made.layout = {first,
                 body.vertex_count,
                 static_cast<std::uint32_t>(tets.size()),
                 first_tet,
                 {static_cast<float>(law.mu), static_cast<float>(law.lambda), static_cast<float>(law.delay),
                  static_cast<std::uint32_t>(law.energy)}};
  WEFT_SET(made.params, gpu::create_uniform(device, made.layout, "solid"));
  std::vector<Vec4f> rests;
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const float* row = &tets.rest[10 * t];
    for (std::size_t k = 0; k < 3; ++k)
      rests.push_back({row[3 * k], row[3 * k + 1], row[3 * k + 2], k == 0 ? row[9] : 0});
  }
  WEFT_SET(made.corners, gpu::Buffer<Four>::create_from(device, nodes_by_four(tets), "tetrahedra"));
  WEFT_SET(made.rests, gpu::Buffer<Vec4f>::create_from(device, rests, "tetrahedra at rest"));
  return made;
}

}  // namespace weft
