#pragma once

#include <cstdint>
#include <span>

#include "base/result.hpp"
#include "contact/pushes/convex_bodies.hpp"
#include "gpu/dispatch.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// Body b of a scene counts in the hit hash as (cloth triangle, kConvexId + b).
inline constexpr std::uint32_t kConvexId = 0xc0000000U;

/// Contacts of cloth triangles with convex bodies.
/// Reads   state.steps; state.position [m]: predicted and previous; model.triangles.
/// Writes  contacts.pushes [m * push_scale; count], state.statistics: added to.
/// Errors  Input: a hull is not closed, or has a triangle without area. Limit: more pairs than can be numbered, or more
///         corners. Shader, OutOfMemory.
/// Source  docs/collision.md, Convex bodies.
class CollidersConvex {
 public:
  CollidersConvex() = default;
  static Result<CollidersConvex> create(gpu::Device& device, const GpuModel& model, const State& state,
                                        const Contacts& contacts, std::span<const mesh::TriangleMesh> hulls,
                                        std::uint32_t workgroup_size);
  void record(gpu::ComputePass& pass) const { dispatch_.record(pass); }

 private:
  gpu::Buffer<ConvexBody> bodies_;
  gpu::Buffer<Vec4f> places_;
  gpu::Buffer<std::uint32_t> words_;
  gpu::Dispatch dispatch_;
};

}  // namespace weft::contact
