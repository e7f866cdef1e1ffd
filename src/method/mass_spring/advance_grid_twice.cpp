#include "method/mass_spring/advance_grid_twice.hpp"

#include "method/mass_spring/grid_params.hpp"

namespace weft {
namespace {

// As in src/method/mass_spring/advance_grid_twice.wgsl.
constexpr std::uint32_t kTileWidth = 16, kTileHeight = 8, kInvocations = 256;

}  // namespace

Result<AdvanceGridTwice> AdvanceGridTwice::create(gpu::Device& device, const Model& model, const State& state,
                                                  const ClothModel& cloth) {
  AdvanceGridTwice made;
  WEFT_TRY(kernel, gpu::Kernel::create(device, "method/mass_spring/advance_grid_twice.wgsl",
                                       grid_constants(cloth), kInvocations));
  made.kernel_ = std::move(kernel);
  const GridParams params = grid_params(cloth, kInvocations);
  WEFT_TRY(buffer, gpu::Buffer<GridParams>::create_from(device, std::span(&params, 1), "grid params",
                                                        gpu::kUniform | gpu::kCopyTarget));
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, made.kernel_.bind({state.steps, buffer, state.position[parity], state.velocity[parity],
                                       model.rest_position, state.motions, state.position[1 - parity],
                                       state.velocity[1 - parity]}));
    made.groups_[parity] = std::move(group);
  }
  made.params_ = std::move(buffer);
  made.tiles_x_ = (params.nx + kTileWidth - 1) / kTileWidth;
  made.tiles_y_ = (params.ny + kTileHeight - 1) / kTileHeight;
  return made;
}

}  // namespace weft
