#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/scene_contact.hpp"
#include "method/solver.hpp"
#include "model/assets.hpp"
#include "model/sewn.hpp"
#include "model/tears.hpp"
#include "sim/frame_recorder.hpp"
#include "sim/frame_steps.hpp"
#include "sim/grabs.hpp"
#include "sim/plan/frame_plan.hpp"
#include "sim/report_ring.hpp"
#include "sim/saved_state.hpp"
#include "sim/snapshot.hpp"
#include "state/last_good.hpp"
#include "state/state.hpp"
#include "state/surface.hpp"
#include "weft/totals.hpp"

namespace weft::sim {

struct WorldOptions {
  std::uint32_t workgroup_size = gpu::kDefaultWorkgroupSize;
  std::optional<ContactRoom> contact_room;  // of proximity contact at first; none: by the number of triangles
  Tears tears = {};                         // what has torn at first
  Sewing sewing = {};                       // and is sewn
  std::optional<bool> two_steps;            // at once, where the solver can; none: where that is quicker
};

using weft::Totals;

/// Refuses more nodes than a buffer of positions can hold, before gigabytes of them are built on the host.
/// Errors  Limit.
Result<void> check_node_count(std::uint64_t nodes, const gpu::Device& device);

/// A running scene: owns the state, orders contact and solver, keeps time. The device must outlive it.
class World {
 public:
  /// Errors  Input: the model cannot be built. Limit, OutOfMemory, Shader, DeviceLost.
  static Result<std::unique_ptr<World>> create(gpu::Device& device, scene::Scene scene, const Assets& assets,
                                               const WorldOptions& options = {});

  /// Submits one frame of substeps and, with them, what draws its end (a list for parity_after()). The host
  /// waits only where three frames are in flight: a caller that must not wait checks has_room first.
  /// Errors  Diverged: a node of an earlier frame was not finite; the state is frozen at the last good frame.
  ///         DeviceLost, OutOfMemory, Shader.
  Result<void> advance_frame(const gpu::CommandList* draw = nullptr);
  /// Takes the reports that have arrived. Errors as advance_frame.
  Result<void> poll();
  bool has_room() const { return reports_.has_room(); }
  /// Waits until all frames have reported. Errors as advance_frame; Diverged for as long as the state is
  /// frozen.
  Result<void> finish();
  /// Grabs a free node, numbered through all cloths, and pulls it to `target` [m]: from the next frame on, by
  /// a part of the way in each substep, no faster than grab_speed(). Its springs and contacts go on. Errors
  /// Input: no such node; it is pinned, moved or grabbed. Limit: scene::kMaxGrabs are grabbed.
  Result<void> grab(std::uint32_t node, const Vec3d& target);
  /// Pulls a node that grab() has grabbed to another place. Errors  Input: it is not grabbed.
  Result<void> drag(std::uint32_t node, const Vec3d& target);
  /// Lets go a node that grab() has grabbed: it goes on with its velocity. Errors  Input: it is not grabbed.
  Result<void> release(std::uint32_t node);

  /// What grab() holds, in no order.
  const std::vector<Grabbed>& grabbed() const { return grabs_->held(); }

  /// Takes over gravity, external force, drag, wind and the numbers of air of a scene that is this one otherwise, from
  /// the next frame on; and its title, description, time.frames, camera, colours, looks, materials, render.view,
  /// render.size and render.light. The step stays as it is. Errors  Input: something else differs
  /// (scene::fixed_difference). Limit: the drag makes the step unstable.
  Result<void> change(const scene::Scene& scene);

  /// Back to the rest state at time 0; what grab() holds is let go.
  Result<void> reset();

  /// The current state, waited for. After finish() only is it known that no frame before it has to be repeated.
  Result<Snapshot> snapshot();
  /// The first part of that alone. Errors  as snapshot.
  Result<NodeState> node_state() const;
  /// The rigid bodies now, waited for; none: the scene has none. Errors  as snapshot.
  Result<std::vector<RigidPlace>> rigid_places() const;
  /// Their buffer; null: the scene has none.
  const contact::RigidBodies* rigid() const { return contact_.rigid(); }
  /// Makes a snapshot the current state, and the one to which a bad or repeated frame rolls back. Time goes on from the
  /// snapshot's, also where its frames had another length: motions, colliders, the scene's grabs and gusts are where
  /// they are then. frame() is the snapshot's where frames have the same length, and counts from 0 otherwise. What it
  /// has of a substep before counts where that was as long as this scene's. What grab() holds stays held. No frame may
  /// be under way. Errors, with nothing changed  Input: it has another number of nodes; a pinned or moved node is not
  /// where this scene has it at that time; the scene grabs a node then that grab() holds. Limit: together they grab too
  /// many.
  Result<void> restore(const Snapshot& snapshot);
  /// The whole state once all frames have reported, to go on from in another world of this scene, to the bits of this
  /// one where `build` and adapter are the same. Errors as finish.
  Result<SavedState> save(const std::string& build);
  /// Goes on from such a state, also where this world has diverged: with its totals, and what was grabbed.
  /// Errors, with nothing changed  Input: it is of another scene, torn or sewn otherwise; those of restore and
  /// grab. DeviceLost, OutOfMemory.
  Result<void> open(const SavedState& saved);
  /// Sets the positions of all nodes [m], where the next frame begins; velocities stay. Waits for the frames before,
  /// keeps no force of a pair, and has no step before it. Errors, with nothing changed  Shape: not one for each node.
  /// Input: not finite; a pinned or moved node is elsewhere. As finish().
  Result<void> set_positions(std::span<const Vec3f> positions);
  /// Sets the velocities of the free nodes [m/s]; those of others are not read. Errors  as set_positions.
  Result<void> set_velocities(std::span<const Vec3f> velocities);
  /// Adds an impulse to each free node [N·s]. Errors  as set_positions.
  Result<void> push(std::span<const Vec3f> impulses);
  /// Moves nodes of the scene's motions of kind "given" to places in the world [m], straight and evenly through the
  /// next frame; there they stay, as the others do where they are. Waits for the frames before. Errors, with nothing
  /// changed  Shape: not one place for each node. Input: no such node; a place is not finite, or farther than the
  /// motion's speed reaches in a frame. As finish().
  Result<void> move(std::span<const std::uint32_t> nodes, std::span<const Vec3f> places);
  /// Those nodes, in rising order.
  std::vector<std::uint32_t> given_nodes() const;
  /// Moves a collider with a motion of kind "given", and what is attached to it, to a place from where the scene puts
  /// it: through the next frame, at constant velocity and spin (scene/screw.hpp), and there it stays. Waits for
  /// nothing. Called again before that frame, it counts instead. Errors, with nothing changed  Input: no such collider;
  /// a number is not finite, the rotation no unit quaternion; a point of it would go faster than the motion's speed.
  Result<void> set_collider(std::size_t collider, const Placement& placement);
  /// Those colliders, in rising order.
  std::vector<std::size_t> given_colliders() const;
  /// Overwrites the current state of one node: for tests of what bad values do.
  void set_node(std::uint32_t node, const Vec4f& position, const Vec4f& velocity);

  const scene::Scene& scene() const { return scene_; }
  gpu::Device& device() const { return device_; }
  const GpuModel& model() const { return model_; }
  const State& state() const { return state_; }
  const Surface& surface() const { return *surface_; }
  const Assets& assets() const { return assets_; }
  /// What has torn of its cloth. A world tears no further by itself: torn_state.hpp.
  const Tears& tears() const { return tears_; }
  /// How far its cloth is sewn. A world sews no further by itself: sewn_state.hpp.
  const Sewing& sewing() const { return sewing_; }
  const Totals& totals() const { return totals_; }
  /// Calls `told` with each frame's number, from 0, once it has reported: in their order, with totals() up to it.
  void on_report(std::function<void(std::uint32_t frame)> told) { told_ = std::move(told); }
  /// What the last frame that was not repeated has reported.
  const Statistics& last_report() const { return last_report_; }
  /// The method, the largest stable step, the substeps: the decisions before the first frame.
  const FramePlan& plan() const { return plan_; }
  std::uint32_t substeps() const { return plan_.substeps(); }
  /// Of any frame: more where something is moved fast (docs/contact.md).
  std::uint32_t most_substeps() const { return plan_.most_substeps(); }
  double step() const { return plan_.step(); }  // [s]
  std::uint32_t frame() const { return asked_; }
  double time() const { return plan_.begin_of(asked_); }  // [s]
  std::uint64_t sliver_count() const { return slivers_; }
  std::uint64_t element_count(ElementKind kind) const {
    return element_counts_[static_cast<std::size_t>(kind)];
  }
  /// How many pairs act on each vertex at the end of a frame, f32, while count_contacts is on; null where no
  /// pairs are listed (scene::ContactMethod).
  const gpu::Buffer<float>* contact_counts() const { return contact_.counts(); }
  /// Errors  Shader.
  Result<void> count_contacts(bool on);
  /// Which of State's buffers holds the current state.
  std::uint32_t parity() const { return parity_; }
  /// Which it will be after one more frame.
  std::uint32_t parity_after() const { return parity_after_frames(asked_ + 1 - frame_); }
  /// The commands of a frame of this many substeps that begins with this parity.
  const gpu::CommandList& frame_commands(std::uint32_t parity, std::uint32_t substeps) {
    return recorder_.commands(parity, substeps);
  }

 private:
  World(gpu::Device& device, scene::Scene scene) : device_(device), scene_(std::move(scene)) {}
  Result<void> build(const Assets& assets, const WorldOptions& options);
  Result<void> submit_frame(const gpu::CommandList* draw);
  /// Goes back to before a frame whose lists were too short, with longer ones.
  Result<void> repeat_from(const Report& report);
  std::uint32_t parity_after_frames(std::uint32_t count) const;
  /// Derived from the state, for drawing.
  Result<void> submit_surface();
  /// Derived from the rest state before the first frame.
  Result<void> submit_rest();
  void write_motions(std::uint32_t substeps);
  /// Refuses a snapshot of other nodes, or whose kinematic nodes are not where this scene has them at its time.
  Result<void> check_nodes(const Snapshot& snapshot) const;
  Result<void> check_places(const Snapshot& snapshot) const;
  Result<void> put_back(const Snapshot& snapshot);
  /// Whether a snapshot's state of a substep before is what the next substep looks back on.
  bool takes_history(const Snapshot& snapshot) const;
  /// Makes its positions and velocities the current state, and the one to which a bad or repeated frame rolls back.
  Result<void> write_state(NodeState& state);
  /// Of a node that a program moves, its motion; else null.
  const scene::MotionGiven* given(std::size_t node) const;
  void set_given(std::size_t node, const scene::MotionGiven& way);
  /// Has them stay where positions have them.
  void hold_given(std::span<const Vec4f> positions);
  /// How a given collider moves, and what is attached to it.
  void set_ways(std::size_t collider, const std::vector<scene::CarriedWay>& ways);
  void clear_statistics() const;
  Result<void> take_reports(bool wait_for_all);
  Result<void> take(const Report& report);

  gpu::Device& device_;
  scene::Scene scene_;
  Assets assets_;
  Tears tears_;
  Sewing sewing_;
  GpuModel model_;
  State state_;
  FramePlan plan_;
  contact::SceneContact contact_;
  std::unique_ptr<Solver> solver_;
  std::optional<Surface> surface_;
  std::optional<LastGood> last_good_;
  FrameRecorder recorder_;
  ReportRing reports_;
  std::optional<Grabs> grabs_;
  FrameSteps steps_;
  std::vector<Extent> extents_;  // of colliders where the scene puts them; empty where no program moves one
  std::vector<Vec4f> motion_rows_;  // of one frame; kept so that a frame allocates nothing
  std::uint32_t parity_ = 0;
  std::uint32_t frame_ = 0;    // submitted
  std::uint32_t asked_ = 0;    // by advance_frame: more than that while frames are repeated
  std::uint32_t attempt_ = 0;  // counts up when frames are repeated
  std::array<std::uint64_t, kElementKinds> element_counts_{};
  std::uint64_t slivers_ = 0;
  Totals totals_;
  Statistics last_report_;
  std::function<void(std::uint32_t)> told_;
  std::optional<Error> diverged_;  // of the first bad frame
  std::uint32_t bad_frame_ = 0;    // its number
};

}  // namespace weft::sim
