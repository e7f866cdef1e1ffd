#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contact/proximity/contact_counts.hpp"
#include "contact/stages/stages.hpp"
#include "model/assets.hpp"
#include "scene/scene.hpp"
#include "state/state.hpp"

namespace weft::contact {

class Proximity;
class Pushes;
class RigidBodies;

/// The inputs of a scene's contact besides the scene itself.
struct SceneContactSetup {
  std::optional<ContactRoom> room;  // of proximity's lists at first; none: by the number of triangles
  std::uint32_t most_substeps = 1;  // of any frame
  std::uint32_t interval = 4;       // substeps from one that may search to the next
  double step = 0;                  // length of a substep, where frames are not cut [s]
  SolvedContact solved = {};
  std::uint32_t workgroup_size = gpu::kDefaultWorkgroupSize;
};

/// The contact of a scene: its buffers and its stages, whichever method the scene names; nothing where it has none.
class SceneContact {
 public:
  SceneContact();
  SceneContact(SceneContact&&) noexcept;
  SceneContact& operator=(SceneContact&&) noexcept;
  ~SceneContact();

  /// Errors  Input, Limit, Shader, OutOfMemory.
  static Result<SceneContact> create(gpu::Device& device, const GpuModel& model, const State& state,
                                     const scene::Scene& scene, const Assets& assets,
                                     const SceneContactSetup& setup);

  /// Null where the scene has no contact.
  const Contacts* contacts() const { return contacts_ ? &*contacts_ : nullptr; }
  const Stages& stages() const;

  /// Fills contact's part of the block of a frame's substep, but for collider_travel, which each frame changes.
  void fill(StepBlock::Contact& part, const scene::Scene& scene, std::uint32_t substep) const;
  /// Writes where the colliders are in each substep of the frame that begins at `time` [s].
  void write_places(gpu::Device& device, const scene::Scene& scene, double time, double step,
                    std::uint32_t substeps);

  /// Makes lists longer that were too short, if any was. Recorded commands that name them are void. Errors  Limit,
  /// OutOfMemory.
  Result<void> make_room(gpu::Device& device, const State& state, const ContactRoom& wanted);
  /// Takes in what a frame has reported. True: stages record otherwise from now on.
  bool adapt(const Statistics& report);
  /// At the end of a frame: keeps what the next one begins with.
  void end_frame(gpu::ComputePass& pass) const;
  /// Forgets that, for a state that does not go on from the frame before.
  void record_rest(gpu::CommandList& list) const;
  /// That, as words: for each pair of features that acts at the end of the last frame, kKeptWords (its numbers, its
  /// force).
  Result<std::vector<std::uint32_t>> forces(gpu::Device& device) const;
  /// Takes it over from a world of the same scene. True if that took longer lists: recorded commands that name them are
  /// void. Errors  Limit, OutOfMemory.
  Result<bool> set_forces(gpu::Device& device, const State& state, std::span<const std::uint32_t> forces);
  /// Obstacles' demands on vertices, for a solver whose matrix has them; null: none.
  const gpu::Buffer<std::int32_t>* presses() const;
  /// The forces with which such a solver holds vertices, kHoldWords each; none: it does not.
  Result<std::vector<std::int32_t>> hold_forces(gpu::Device& device) const;
  void set_hold_forces(gpu::Device& device, std::span<const std::int32_t> forces);
  /// Clears the traces of the first attempt before a frame is repeated.
  void record_forget(gpu::CommandList& list) const;

  /// Null: the scene has none.
  const RigidBodies* rigid() const;

  /// How many pairs act on each vertex, f32, while they are counted; null where no pairs are listed.
  const gpu::Buffer<float>* counts() const { return proximity_ ? &counts_ : nullptr; }
  bool counting() const { return counter_.has_value(); }
  /// Whether counts() is kept up from now on. Errors  Shader.
  Result<void> count(gpu::Device& device, bool on);
  /// Counts, while that is on: at the end of a frame.
  void record_counts(gpu::ComputePass& pass) const;

 private:
  Result<void> create_proximity(gpu::Device& device, const GpuModel& model, const State& state,
                                const scene::Scene& scene, const Assets& assets,
                                const SceneContactSetup& setup);
  Result<void> create_pushes(gpu::Device& device, const GpuModel& model, const State& state,
                             const scene::Scene& scene, const Assets& assets, const SceneContactSetup& setup);
  Result<void> create_counter(gpu::Device& device);

  std::optional<Contacts> contacts_;
  std::unique_ptr<Pushes> pushes_;        // of methods paper and bvh
  std::unique_ptr<Proximity> proximity_;  // of method proximity
  gpu::Buffer<float> counts_;
  std::optional<ContactCounts> counter_;
  std::uint32_t interval_ = 4;  // substeps from one that may search to the next
};

}  // namespace weft::contact
