#pragma once

#include <cstddef>
#include <cstdint>

#include "base/vec.hpp"

namespace weft {

/// Mirror of shaders/shared/step.wgsl.
struct StepParams {
  Vec4f acceleration;  // [m/s²]
  float dt = 0;        // [s]
  float drag = 0;      // [1/s]
  std::uint32_t vertex_count = 0;
  std::uint32_t spring_count = 0;
  float force_scale = 1;  // fixed-point units per newton
  float force_limit = 0;  // [N]
  float push_scale = 1;   // fixed-point units per metre
  float thickness = 0;    // [m]
  float max_push = 0;     // [m]
  std::uint32_t first_motion = 0;
  std::uint32_t padding[50] = {};  // to kStepStride
};
static_assert(sizeof(StepParams) == 256);
static_assert(offsetof(StepParams, dt) == 16 && offsetof(StepParams, first_motion) == 52);

}  // namespace weft
