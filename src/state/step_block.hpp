#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/vec.hpp"
#include "gpu/command_list.hpp"
#include "scene/wind.hpp"

namespace weft {

/// Whether a substep looks for pairs of features.
enum class Detect : std::uint32_t { No, IfDue, Always };

/// What the kernels of a substep read. Each part is filled by its owner, and has room to grow up to its alignment.
/// Mirror of src/state/step.wgsl.
struct StepBlock {
  /// By the frame plan.
  struct alignas(32) Time {
    float dt = 0;          // [s]
    float step_ratio = 1;  // this substep's length by that of the one before; 0: without history
  };
  /// By the model.
  struct alignas(32) Nodes {
    std::uint32_t count = 0;
    std::uint32_t first_motion = 0;
  };
  /// By contact::SceneContact.
  struct alignas(64) Contact {
    float thickness = 0;       // [m]
    float self_thickness = 0;  // [m]; 0: cloth does not meet cloth
    float push_scale = 1;      // fixed-point units per metre
    float max_push = 0;        // [m]
    float most_reach = 0;      // [m]
    float restitution = 0;
    float collider_travel = 0;  // in the substep, at most [m]
    Detect detect = Detect::No;
    std::uint32_t point_count = 0;  // of colliders
    std::uint32_t first_place = 0;
    std::uint32_t most_delay = 0;  // of a frame [µs]
  };
  /// By the scene's fields: gravity, drag, wind, air.
  struct alignas(128) Air {
    Vec4f acceleration;              // [m/s²]
    Vec4f wind;                      // [m/s]; w: 1 where wind blows
    Vec4f wind_wave_a, wind_wave_b;  // [1/m]; w: in [0, 1)
    Vec4f gust_a, gust_b;            // [m/s]
    float drag = 0;                  // [1/s]
    float pressure = 0;              // of the scene's air, with half its density [kg/m³]
    float lift = 0, friction = 0;    // [kg/m³]
  };
  /// By what holds nodes: the first five by GrabSlots.
  struct alignas(128) Hands {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t still = 0;
    std::uint32_t first_still = 0;
    std::uint32_t first_moving = 0;
    float rate = 0;   // [1/s]
    float speed = 0;  // [m/s]
  };
  /// By the solver: its own numbers.
  struct alignas(128) Method {
    std::uint32_t spring_count = 0;
    float force_scale = 1;  // fixed-point units per newton
    float force_limit = 0;  // [N]
  };

  Time time;
  Nodes nodes;
  Contact contact;
  Air air;
  Hands hands;
  Method method;
};
static_assert(sizeof(StepBlock) == gpu::kStepStride);

/// Sets what the air pushes with; none: nothing.
void set_air(StepBlock::Air& part, const std::optional<scene::Air>& air);

/// Sets the wind; `turns` is how far time has brought each wave.
void set_wind(StepBlock::Air& air, const scene::WindField& wind, const std::array<double, 2>& turns);

}  // namespace weft
