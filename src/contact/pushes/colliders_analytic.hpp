#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/result.hpp"
#include "base/vec.hpp"
#include "gpu/kernel.hpp"
#include "scene/scene.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// Collider c of a scene counts in the hit hash as (vertex, kAnalyticId + c); spheres come first.
inline constexpr std::uint32_t kAnalyticId = 0x80000000U;

/// Mirror of AnalyticCollider in src/contact/pushes/analytic.wgsl.
struct AnalyticCollider {
  Vec4f point;   // [m]; w: radius [m]
  Vec4f normal;  // w: 0 for a sphere, 1 for a plane
};
static_assert(sizeof(AnalyticCollider) == 32);

/// Contacts of nodes with spheres and planes.
/// Reads   state.steps; state.position [m]: predicted and previous.
/// Writes  contacts.pushes [m * push_scale; count], state.statistics: added to.
/// Errors  Input: a radius is not positive or a normal not of unit length. Shader, OutOfMemory.
class CollidersAnalytic {
 public:
  CollidersAnalytic() = default;
  static Result<CollidersAnalytic> create(gpu::Device& device, const State& state, const Contacts& contacts,
                                          std::span<const scene::ColliderSphere> spheres,
                                          std::span<const scene::ColliderPlane> planes,
                                          std::uint32_t workgroup_size);
  void record(gpu::ComputePass& pass) const;

 private:
  gpu::Kernel kernel_;
  gpu::RawBuffer colliders_;
  std::array<gpu::BindGroup, 2> groups_;  // by parity
  std::uint64_t vertex_count_ = 0;
};

}  // namespace weft::contact
