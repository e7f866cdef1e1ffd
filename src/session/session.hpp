// What a host of the engine holds: a device, the scene that was loaded last, and its running world.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gpu/device.hpp"
#include "model/assets.hpp"
#include "scene/override.hpp"
#include "sim/kernel_times.hpp"
#include "sim/mesh_change.hpp"
#include "sim/world.hpp"
#include "view/canvas_view.hpp"

namespace weft {

/// A scene as it was handed over, before any of it is checked.
struct SceneText {
  std::string text;                      // JSON
  std::string file;                      // what messages call it, and where relative mesh paths start
  std::vector<scene::Override> changes;  // applied in their order
};

/// A scene and its meshes, read and checked.
struct Inputs {
  scene::Scene scene;
  Assets assets;
};
/// How a host reads a scene: where meshes come from and how much memory there is differ. Errors  Input, Limit.
using ReadInputs = std::function<Result<Inputs>(const SceneText& source)>;

class Session {
 public:
  /// Opens a device, anew where it was lost; with timestamps where the adapter has them.
  /// Errors  as gpu::Device::create.
  Result<void> open(gpu::DeviceOptions options);
  /// Replaces the world by that of a scene, which `read` reads once the old world is gone.
  /// Errors  Input, Limit, Shader, OutOfMemory, DeviceLost. There is no world afterwards.
  Result<void> load(SceneText source, const ReadInputs& read);
  /// Changes one key of the running scene. Errors as World::change; the world then stays as it is.
  Result<void> set(const std::string& key, const std::string& value);
  void close();

  /// Calls `made` with each world that is made, from the next load on: of a scene whose mesh changes there are several.
  void on_world(std::function<void(sim::World& world)> made) { made_ = std::move(made); }

  /// Draws there from now on; before the next load.
  void set_canvas(const view::Canvas& canvas) { canvas_ = canvas; }
  Result<void> resize(std::uint32_t width, std::uint32_t height);
  Result<void> set_view(scene::View view);

  /// Whether cloth may tear or is sewn: then change_mesh is due before each frame.
  bool changes_mesh() const { return world_ && sim::may_change_mesh(world_->scene()); }
  /// As sim::change_mesh; what is drawn goes on from where it was seen. `build` as of save_state.
  Result<sim::MeshChange> change_mesh(const std::string& build);
  Result<void> advance(bool draw);
  /// Back to the rest state at time 0, whole and unsewn. Errors  as sim::reset_whole.
  Result<void> reset();
  /// Draws the current state.
  Result<void> draw();
  /// The node under (x, y) in clip coordinates; picked() has it until the next call.
  Result<void> pick(double x, double y);
  const std::optional<render::PickedNode>& picked() const { return picked_; }
  /// The nodes in an area of the picture, seen or hidden; picked_within() has them until the next call.
  Result<void> pick_within(const render::PickArea& area);
  const std::vector<std::uint32_t>& picked_within() const { return picked_within_; }
  /// The state as it is, kept until the next call.
  Result<void> take_snapshot();
  const sim::Snapshot& snapshot() const { return snapshot_; }
  /// The whole state as bytes, to go on from later; `build` names the host and its version. Errors  as World::finish.
  Result<std::vector<std::byte>> save_state(const std::string& build);
  /// Goes on from such bytes of this scene. "" where they come from this build and adapter: then bits are the same too;
  /// else sim::other_origin. Errors  those of sim::read_saved_state and World::open, with nothing changed.
  Result<std::string> open_state(std::span<const std::byte> bytes, const std::string& build);
  /// The bytes of a file of the present shape: "obj", "ply" or "glb".
  Result<void> export_mesh(const std::string& format);
  const std::vector<std::byte>& exported() const { return exported_; }

  /// What each kernel takes: empty where the adapter has no timestamps. The state is as it was then.
  /// Errors  Failure: nothing was simulated, or a frame has one step. DeviceLost.
  Result<std::vector<sim::KernelTime>> time_passes();

  gpu::Device& device() const { return *device_; }  // there is one from open() to close()
  scene::View shown() const { return shown_; }
  sim::World* world() { return world_.get(); }
  view::CanvasView* canvas_view() { return view_ ? &*view_ : nullptr; }

 private:
  Result<void> build(SceneText source, const ReadInputs& read);
  /// Of a world that was just made.
  Result<void> show_world();
  /// After what may have made the world anew, or have left none: it is drawn from where it was seen.
  Result<void> follow(const Result<bool>& anew);

  std::unique_ptr<gpu::Device> device_;
  SceneText source_;
  std::unique_ptr<sim::World> world_;
  view::Canvas canvas_;
  scene::View shown_ = scene::View::Textured;
  std::function<void(sim::World& world)> made_;
  std::optional<view::CanvasView> view_;  // draws from the world's buffers: goes before it
  std::optional<render::PickedNode> picked_;
  std::vector<std::uint32_t> picked_within_;
  sim::Snapshot snapshot_;
  std::vector<std::byte> exported_;
};

}  // namespace weft
