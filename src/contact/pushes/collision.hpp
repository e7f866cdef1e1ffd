// Finds where the cloth meets its colliders, for a solver to answer.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/result.hpp"
#include "contact/pushes/colliders_analytic.hpp"
#include "contact/pushes/pairs_bvh.hpp"
#include "contact/pushes/pairs_paper.hpp"
#include "contact/proximity/proximity.hpp"
#include "gpu/command_list.hpp"
#include "mesh/triangle_mesh.hpp"
#include "scene/scene.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// What the cloth can touch, and how that is found. The last three change no result.
struct CollisionSetup {
  scene::ContactMethod method = scene::ContactMethod::Bvh;
  double thickness = 0.005;                 // [m]
  std::vector<mesh::TriangleMesh> objects;  // in the world [m], closed and facing outward, without zero areas
  std::vector<scene::ColliderSphere> spheres;
  std::vector<scene::ColliderPlane> planes;
  std::uint64_t max_pairs = 1ULL << 28U;  // of a dispatch of method paper: 13 ms at 20 G pairs/s
  std::uint32_t workgroup_size = 256;
  std::uint32_t triangles_each =
      0;  // cloth triangles an invocation of method bvh, 1 or 2; 0: the faster one here
};

/// The collision part of a substep: after the solver has predicted positions, before it answers.
/// Reads   state.steps: thickness, max_push [m], push_scale (of this class); state.position [m]: predicted,
/// previous. Writes  contacts.pushes [m * push_scale; count]; state.statistics: hits, hit_hash,
/// contact_overflow. Added to, so
///         the solver clears the first and the frame the second.
/// Errors  Input: an object has a triangle without area, a radius or normal is off. Limit, Shader,
/// OutOfMemory. Source: Sung et al.; docs/collision.md.
class Collision {
 public:
  Collision() = default;
  static Result<Collision> create(gpu::Device& device, const Model& model, const State& state,
                                  const Contacts& contacts, const CollisionSetup& setup);
  void record(gpu::ComputePass& pass) const;

  /// For StepParams: fixed-point units per metre, and the length that a push is cut to [m].
  float push_scale() const { return push_scale_; }
  float max_push() const { return max_push_; }
  float thickness() const { return thickness_; }
  std::uint32_t object_triangle_count() const { return object_triangle_count_; }
  /// Of a substep.
  std::size_t dispatch_count() const;

 private:
  std::optional<PairsPaper> paper_;
  std::optional<PairsBvh> bvh_;
  std::optional<CollidersAnalytic> analytic_;
  float push_scale_ = 1, max_push_ = 0, thickness_ = 0;
  std::uint32_t object_triangle_count_ = 0;
};

}  // namespace weft::contact
