#include "method/mass_spring/spring_network.hpp"

#include <algorithm>

#include "element/triple/triple.hpp"
#include "mesh/lumped.hpp"

namespace weft {
namespace {

constexpr std::uint32_t kLargestPart = 64;  // nodes a side

}  // namespace

SpringNetwork stiffest_part(const Model& model, const Body& body) {
  SpringNetwork network;
  const std::uint32_t first = body.first_vertex;
  if (body.grid) {
    mesh::Grid grid = *body.grid;
    grid.nx = std::min(grid.nx, kLargestPart);
    grid.ny = std::min(grid.ny, kLargestPart);
    grid.width *= static_cast<double>(grid.nx - 1) / (body.grid->nx - 1);
    grid.height *= static_cast<double>(grid.ny - 1) / (body.grid->ny - 1);
    const double corner_area = mesh::vertex_areas(*body.grid)[0];
    const double density = model.mass[first] / corner_area;  // unused where every node weighs the same
    const std::vector<double> areas = mesh::vertex_areas(grid);
    for (std::uint32_t j = 0; j < grid.ny; ++j)
      for (std::uint32_t i = 0; i < grid.nx; ++i) {
        const mesh::RestPoint p = mesh::rest_point(grid, i, j);
        const double mass = body.weights == mesh::BoundaryWeights::Uniform
                                ? model.mass[first]
                                : density * areas[mesh::node_index(grid, i, j)];
        network.position.push_back(Vec4f::from(Vec3d{p.x, p.y, 0}.to<float>(), static_cast<float>(1 / mass)));
      }
    network.springs = build_springs(grid, body.material(), 0);
    network.triples = build_triples(grid, body.stiffness.bending, body.weights, 0);
  } else {
    for (std::uint32_t v = first; v < first + body.vertex_count; ++v)
      network.position.push_back(
          Vec4f::from(model.rest_position[v].to<float>(), static_cast<float>(1 / model.mass[v])));
    network.springs = model.elements(ElementKind::Spring, body);
    for (std::uint32_t& node : network.springs.nodes) node -= first;
  }
  return network;
}

}  // namespace weft
