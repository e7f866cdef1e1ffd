// What the textured view draws a cloth as: its look, resolved to colours and numbers.
#pragma once

#include <vector>

#include "gpu/buffer.hpp"
#include "render/inputs.hpp"

namespace weft::render {

/// Mirror of Fabric in src/render/weave.wgsl, whose comments say what each is.
struct FabricParams {
  Vec4f tint, warp, weft, stripe, accent, back, rim, gloss;
  std::uint32_t weave = 0, pattern = 0, period = 2, shift = 1;
};

/// The look of cloth number `index`, in its own colour, its look's or a palette's.
FabricParams fabric_of(const ClothRange& range, std::size_t index);
/// sRGB: of the warp of cloth number `index` by its look, where it has no colour of its own.
Vec3f color_of(const scene::Look& look, std::size_t index);
/// That of each cloth.
Result<std::vector<gpu::Buffer<FabricParams>>> create_fabrics(gpu::Device& device,
                                                              const std::vector<ClothRange>& ranges);

}  // namespace weft::render
