// A whole scene on the CPU, in double: the oracle of whole frames, and the page's fallback without WebGPU.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "contact/reference/proximity/proximity.hpp"
#include "contact/reference/pushes/contact_pairs.hpp"
#include "contact/reference/pushes/convex_pushes.hpp"
#include "contact/reference/pushes/pushes.hpp"
#include "method/mass_spring/reference/mass_spring.hpp"
#include "method/stepper.hpp"
#include "model/assets.hpp"
#include "model/model.hpp"
#include "scene/scene.hpp"
#include "sim/plan/frame_plan.hpp"

namespace weft::reference {

/// The springs of a model with the very numbers that the kernels get: f32, here widened.
std::vector<SpringLink> spring_links(const Model& model);

/// Those and all other elements of a model, and its nodes' inverse masses; at no place, in no field.
MassSpringSystem elements_of(const Model& model);

/// The energies of a state of that model [J], which need not be in double: a running world's, read back.
/// Reads  system: of elements_of; position [m], velocity [m/s]: one a node; creases: State::creases; acceleration:
///        gravity and the external force [m/s²].
EnergySums energies_at(MassSpringSystem& system, std::span<const Vec4f> position,
                       std::span<const Vec4f> velocity, std::span<const Vec4f> creases,
                       const Vec3d& acceleration);

/// The force on each node of such a state by its elements, what closed cloths enclose, and its weight [N]: a node that
/// is pinned, moved or grabbed is held with the opposite. That of air, drag and contact is not in it.
/// Reads  as energies_at; mass [kg]: one a node, of pinned ones too.
std::vector<Vec3d> forces_at(MassSpringSystem& system, std::span<const Vec4f> position,
                             std::span<const Vec4f> velocity, std::span<const Vec4f> creases,
                             std::span<const double> mass, const Vec3d& acceleration);

/// What sim::World does with a scene, in the same order. Adds, multiplies, divides and takes roots only, in
/// one order: the same bits on every machine, native or WebAssembly.
class Simulation {
 public:
  /// Errors  Input: the model cannot be built, an object has a triangle without area. Limit: "auto" needs too many
  ///         substeps.
  static Result<Simulation> create(const scene::Scene& scene, const Assets& assets);

  /// Errors  Diverged: a node is not finite; the state stays as it was before the frame.
  Result<void> advance_frame();
  /// Back to the rest state at time 0.
  void reset();

  const std::vector<Vec3d>& positions() const { return system_.position; }   // [m]
  const std::vector<Vec3d>& velocities() const { return system_.velocity; }  // [m/s]
  const std::vector<mesh::Triangle>& triangles() const { return model_->triangles; }
  /// XXH3-64 of the bits of position, then velocity (three doubles a node), as 16 hexadecimal digits.
  std::string hash() const;
  /// Kinetic, elastic and gravitational [J].
  double energy() const { return reference::energy(system_); }

  const scene::Scene& scene() const { return scene_; }
  std::uint32_t frame() const { return frame_; }
  double time() const { return frame_ * scene_.time.frame; }  // [s]
  const sim::FramePlan& plan() const { return plan_; }
  std::uint32_t substeps() const { return plan_.substeps(); }
  double step() const { return plan_.step(); }  // [s]; shorter in frames that are cut
  std::uint64_t element_count(ElementKind kind) const { return model_->count(kind); }
  std::uint64_t sliver_count() const { return model_->sliver_count(); }
  /// In all substeps so far. Of cloth triangles with object triangles and convex bodies, of nodes with spheres and
  /// planes; by proximity, pairs of features that act.
  std::uint64_t contacts() const { return contacts_; }
  /// What contact method proximity knows; null with the others.
  const Proximity* proximity() const { return proximity_ ? &*proximity_ : nullptr; }

 private:
  Simulation(const scene::Scene& scene, Model model)
      : scene_(scene), model_(std::make_unique<Model>(std::move(model))) {}
  Result<void> add_colliders(const Assets& assets);

  /// One of `count` of this frame.
  void substep(std::uint32_t number, const sim::FramePlan::Frame& frame);
  /// The nodes that the scene grabs in the substep that ends at `time` [s], and their targets.
  void set_grabs(double time);
  /// Where kinematic nodes are at `time` [s]; of all others the place that they had.
  std::vector<Vec3d> places_at(double time, const std::vector<Vec3d>& previous) const;
  void answer_contacts(const std::vector<Vec3d>& previous);
  bool finite() const;

  scene::Scene scene_;
  std::unique_ptr<Model> model_;  // where the stepper finds it, also once this is moved
  MassSpringSystem system_;
  sim::FramePlan plan_;
  std::unique_ptr<Stepper> stepper_;
  std::uint32_t frame_ = 0;

  mesh::TriangleMesh
      object_;  // all objects but convex hulls as one, in their order: what a pair's numbers mean
  std::optional<ObjectTriangles> object_triangles_;
  std::vector<ConvexBody> convex_;
  std::vector<scene::ColliderSphere> spheres_;
  std::vector<scene::ColliderPlane> planes_;
  PushLimits push_limits_;
  std::optional<Proximity> proximity_;
  std::uint64_t contacts_ = 0;
};

}  // namespace weft::reference
