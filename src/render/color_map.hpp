// Viridis (Smith and van der Walt 2015, matplotlib; CC0): equal steps look equal, also to the colour-blind.
#pragma once

#include <array>
#include <cstddef>

#include "base/vec.hpp"

namespace weft::render {

inline constexpr std::size_t kColorMapSize = 9;

/// sRGB in [0, 1] at equal distances; between them the linear values are interpolated, as on the GPU.
inline constexpr std::array<Vec3f, kColorMapSize> kColorMap = {{{0.267004F, 0.004874F, 0.329415F},
                                                                {0.278826F, 0.175490F, 0.483397F},
                                                                {0.229739F, 0.322361F, 0.545706F},
                                                                {0.172719F, 0.448791F, 0.557885F},
                                                                {0.127568F, 0.566949F, 0.550556F},
                                                                {0.157851F, 0.683765F, 0.501686F},
                                                                {0.369214F, 0.788888F, 0.382914F},
                                                                {0.678489F, 0.863742F, 0.189503F},
                                                                {0.993248F, 0.906157F, 0.143936F}}};

float srgb_to_linear(float encoded);
float linear_to_srgb(float linear);
Vec3f srgb_to_linear(const Vec3f& encoded);

/// The colour of a value in [0, 1], sRGB.
Vec3f map_color(float value);

}  // namespace weft::render
