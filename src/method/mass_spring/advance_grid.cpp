#include "method/mass_spring/advance_grid.hpp"

#include "method/mass_spring/grid_params.hpp"

namespace weft {

Result<AdvanceGrid> AdvanceGrid::create(gpu::Device& device, const Model& model, const State& state,
                                        const Predicted& predicted, const ClothModel& cloth,
                                        std::uint32_t workgroup_size) {
  AdvanceGrid made;
  WEFT_TRY(kernel, gpu::Kernel::create(device, "method/mass_spring/advance_grid.wgsl", grid_constants(cloth),
                                       workgroup_size));
  made.kernel_ = std::move(kernel);
  const GridParams params = grid_params(cloth, workgroup_size);
  WEFT_TRY(buffer, gpu::Buffer<GridParams>::create_from(device, std::span(&params, 1), "grid params",
                                                        gpu::kUniform | gpu::kCopyTarget));
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, made.kernel_.bind({state.steps, buffer, state.position[parity], state.velocity[parity],
                                       model.rest_position, state.motions, state.position[1 - parity],
                                       *predicted[parity]}));
    made.groups_[parity] = std::move(group);
  }
  made.params_ = std::move(buffer);
  const std::uint32_t tile_height = workgroup_size / params.tile_width;
  const std::uint64_t tiles_y = (params.ny + tile_height - 1) / tile_height;
  made.count_ = params.tiles_x * tiles_y * workgroup_size;
  return made;
}

}  // namespace weft
