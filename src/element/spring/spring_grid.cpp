#include "element/spring/spring_grid.hpp"

#include <cmath>

#include "element/triple/triple.hpp"

namespace weft {

SpringGrid spring_grid(const mesh::Grid& grid, const SpringMaterial& material, std::uint32_t first_vertex) {
  const double di = grid.width / (grid.nx - 1), dj = grid.height / (grid.ny - 1);
  const auto [bending_i, bending_j] = triple_stiffness(grid, material.stiffness.bending);
  const auto damping = [&](double stiffness) {
    return static_cast<float>(stiffness > 0 ? material.damping : 0);
  };
  const scene::Stiffness& k = material.stiffness;
  SpringGrid made;
  made.first_vertex = first_vertex;
  made.nx = grid.nx;
  made.ny = grid.ny;
  made.uniform_weights = material.weights == mesh::BoundaryWeights::Uniform ? 1 : 0;
  made.stiffness = {static_cast<float>(k.structural), static_cast<float>(k.shear), static_cast<float>(k.bend),
                    0};
  made.damping = {damping(k.structural), damping(k.shear), damping(k.bend), 0};
  made.rest_length = {static_cast<float>(di), static_cast<float>(dj),
                      static_cast<float>(std::sqrt(di * di + dj * dj)), 0};
  if (material.strain_limit)
    made.longest = {static_cast<float>((1 + *material.strain_limit) * di),
                    static_cast<float>((1 + *material.strain_limit) * dj)};
  made.bending = {static_cast<float>(bending_i), static_cast<float>(bending_j)};
  return made;
}

}  // namespace weft
