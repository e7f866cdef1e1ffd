// The paper's contact: every cloth triangle that meets an object's triangle is pushed out.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/result.hpp"
#include "contact/pushes/colliders_analytic.hpp"
#include "contact/pushes/colliders_convex.hpp"
#include "contact/pushes/contact_response.hpp"
#include "contact/pushes/pairs_bvh.hpp"
#include "contact/pushes/pairs_paper.hpp"
#include "contact/stages/stages.hpp"
#include "mesh/triangle_mesh.hpp"
#include "scene/scene.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// The obstacles, and the way of finding hits. The last three change no result.
struct PushSetup {
  scene::ContactMethod method = scene::ContactMethod::Bvh;  // or Paper
  double thickness = 0.005;                                 // [m]
  std::vector<mesh::TriangleMesh> objects;  // in the world [m], closed and facing outward, without zero areas
  std::vector<mesh::TriangleMesh> hulls;    // in the world [m], as mesh::convex_hull makes them
  std::vector<scene::ColliderSphere> spheres;
  std::vector<scene::ColliderPlane> planes;
  std::uint64_t max_pairs = 1ULL << 28U;  // of a dispatch of method paper: 13 ms at 20 G pairs/s
  std::uint32_t workgroup_size = 256;
  std::uint32_t triangles_each = 0;  // an invocation of method bvh, 1 or 2; 0: the faster one here
};

/// Contact methods paper and bvh. `measure` adds up the pushes of the pairs that intersect at the predicted positions,
/// or are nearer than the thickness to a sphere, a plane or a convex body; `hold_back` moves each vertex to its
/// previous position plus their mean (Algorithm 2). There are no pairs to answer between.
/// Reads   state.steps: thickness, max_push [m], push_scale (of this class); state.position [m].
/// Writes  contacts.pushes [m * push_scale; count]; state.position, state.velocity of vertices with contacts;
///         state.statistics: hits, hit_hash, contact_overflow.
/// Errors  Input: an object has a triangle without area, a radius or normal is off. Limit, Shader, OutOfMemory.
/// Source  Sung et al.; docs/collision.md.
class Pushes : public Stages {
 public:
  Pushes() = default;
  static Result<Pushes> create(gpu::Device& device, const GpuModel& model, const State& state,
                               const Contacts& contacts, const PushSetup& setup);
  void measure(gpu::ComputePass& pass) const override;
  void hold_back(gpu::ComputePass& pass) const override;

  /// For StepBlock: fixed-point units per metre, and the length that a push is cut to [m].
  float push_scale() const { return push_scale_; }
  float max_push() const { return max_push_; }

 private:
  std::optional<PairsPaper> paper_;
  std::optional<PairsBvh> bvh_;
  std::optional<CollidersAnalytic> analytic_;
  std::optional<CollidersConvex> convex_;
  std::optional<ContactResponse> response_;
  float push_scale_ = 1, max_push_ = 0;
};

}  // namespace weft::contact
