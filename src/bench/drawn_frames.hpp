#pragma once

#include "bench/measure.hpp"

namespace weft::bench {

/// Frames as the paper counts them: one search for contact, one step, then normals and a picture of
/// 1280 x 720; the queue is drained after each. From the rest state, or near a `pose`. The scene has its
/// step: fix_step. Errors  as sim::World::create, restore and advance_frame.
Result<Timing> time_drawn_frames(gpu::Device& device, scene::Scene scene, const Assets& assets,
                                 const Pose* pose, double budget_ms, std::uint32_t least);

}  // namespace weft::bench
