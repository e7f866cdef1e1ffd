#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/vec.hpp"
#include "scene/grab.hpp"
#include "scene/wind.hpp"

namespace weft {

inline constexpr std::uint32_t kNoNode = 0xffffffffU;

/// Whether a substep looks for pairs of features.
enum class Detect : std::uint32_t { No, IfDue, Always };

/// Mirror of src/state/step.wgsl.
struct StepParams {
  Vec4f acceleration;  // [m/s²]; w: how far a collider may go in the substep [m]
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
  float grab_rate = 0;             // [1/s]
  float grab_speed = 0;            // [m/s]
  Vec4f wind;                      // [m/s]; w: 1 where wind blows
  Vec4f wind_wave_a, wind_wave_b;  // [1/m]; w: in [0, 1)
  Vec4f gust_a, gust_b;            // [m/s]
  std::array<std::uint32_t, scene::kMaxGrabs> grab_node = {kNoNode, kNoNode, kNoNode, kNoNode};
  std::array<Vec4f, scene::kMaxGrabs> grab_target = {};  // [m]
  float self_thickness = 0;                              // [m]; 0: cloth does not meet cloth
  float least_reach = 0, most_reach = 0;                 // [m]
  float contact_damping = 0;                             // ζ of docs/contact.md
  Detect detect = Detect::No;
  float step_ratio = 1;           // this substep's length by that of the one before; 0: without history
  std::uint32_t point_count = 0;  // of colliders
  std::uint32_t first_place = 0;
};
static_assert(sizeof(StepParams) == 256);
static_assert(offsetof(StepParams, dt) == 16 && offsetof(StepParams, first_motion) == 52);
static_assert(offsetof(StepParams, wind) == 64 && offsetof(StepParams, gust_b) == 128);
static_assert(offsetof(StepParams, grab_node) == 144 && offsetof(StepParams, grab_target) == 160);
static_assert(offsetof(StepParams, self_thickness) == 224);

/// Sets the wind; `turns` is how far time has brought each wave.
void set_wind(StepParams& params, const scene::WindField& wind, const std::array<double, 2>& turns);

}  // namespace weft
