#include "method/mass_spring/spring_network.hpp"

#include <algorithm>

#include "element/triple/triple.hpp"
#include "mesh/lumped.hpp"

namespace weft {
namespace {

constexpr std::uint32_t kLargestPart = 64;  // nodes a side

}  // namespace

mesh::Grid stiffest_grid(mesh::Grid grid) {
  const std::uint32_t nx = grid.nx, ny = grid.ny;
  grid.nx = std::min(nx, kLargestPart);
  grid.ny = std::min(ny, kLargestPart);
  grid.width *= static_cast<double>(grid.nx - 1) / (nx - 1);
  grid.height *= static_cast<double>(grid.ny - 1) / (ny - 1);
  return grid;
}

std::vector<double> grid_masses(const Model& model, const Body& body, const mesh::Grid& part) {
  const double corner = model.mass[body.first_vertex];
  std::vector<double> masses = mesh::vertex_areas(part);
  if (body.weights == mesh::BoundaryWeights::Uniform) {
    std::fill(masses.begin(), masses.end(), corner);
    return masses;
  }
  const double density = corner / mesh::vertex_areas(*body.grid)[0];
  for (double& mass : masses) mass *= density;
  return masses;
}

SpringNetwork stiffest_part(const Model& model, const Body& body) {
  SpringNetwork network;
  const std::uint32_t first = body.first_vertex;
  if (body.grid) {
    const mesh::Grid grid = stiffest_grid(*body.grid);
    const std::vector<double> masses = grid_masses(model, body, grid);
    for (std::uint32_t j = 0; j < grid.ny; ++j)
      for (std::uint32_t i = 0; i < grid.nx; ++i) {
        const mesh::RestPoint p = mesh::rest_point(grid, i, j);
        const double mass = masses[mesh::node_index(grid, i, j)];
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
