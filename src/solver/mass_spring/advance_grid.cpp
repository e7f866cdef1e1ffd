#include "solver/mass_spring/advance_grid.hpp"

#include <cmath>

namespace weft {

GridParams grid_params(const ClothModel& cloth) {
  const mesh::Grid& grid = *cloth.grid;
  const double di = grid.width / (grid.nx - 1);
  const double dj = grid.height / (grid.ny - 1);
  GridParams params;
  params.first_vertex = cloth.first_vertex;
  params.nx = grid.nx;
  params.ny = grid.ny;
  params.uniform_weights = cloth.weights == mesh::BoundaryWeights::Uniform ? 1 : 0;
  params.stiffness = {static_cast<float>(cloth.stiffness.structural),
                      static_cast<float>(cloth.stiffness.shear), static_cast<float>(cloth.stiffness.bend), 0};
  params.rest_length = {static_cast<float>(di), static_cast<float>(dj),
                        static_cast<float>(std::sqrt(di * di + dj * dj)), 0};
  params.damping = static_cast<float>(cloth.damping);
  return params;
}

Result<AdvanceGrid> AdvanceGrid::create(gpu::Device& device, const gpu::Kernel& kernel, const Model& model,
                                        const State& state, const Predicted& predicted,
                                        const ClothModel& cloth) {
  AdvanceGrid made;
  const GridParams params = grid_params(cloth);
  WEFT_TRY(buffer, gpu::Buffer<GridParams>::create_from(device, std::span(&params, 1), "grid params",
                                                        gpu::kUniform | gpu::kCopyTarget));
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, kernel.bind({state.steps, buffer, state.position[parity], state.velocity[parity],
                                 model.rest_position, state.motions, state.position[1 - parity],
                                 *predicted[parity]}));
    made.groups_[parity] = std::move(group);
  }
  made.params_ = std::move(buffer);
  made.count_ = cloth.vertex_count;
  return made;
}

}  // namespace weft
