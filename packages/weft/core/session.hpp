// What one WebAssembly module holds: a device, the scene that was loaded last, and its running world.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/device.hpp"
#include "scene/override.hpp"
#include "sim/world.hpp"
#include "view.hpp"

namespace weft::web {

class Session {
 public:
  /// Opens the device, anew where it was lost. Errors  NoAdapter, Failure.
  Result<void> open(const std::string& adapter);
  /// Replaces the world by that of the scene in `text`. `changes` are lines of KEY=JSON.
  /// Errors  Input, Limit, Shader, OutOfMemory, DeviceLost. There is no world afterwards.
  Result<void> load(const std::string& text, const std::string& changes);
  /// Changes one key of the running scene. Errors as World::change.
  Result<void> set(const std::string& key, const std::string& value);
  void close();

  /// Draws there from now on; before the next load.
  void set_canvas(const Canvas& canvas) { canvas_ = canvas; }
  Result<void> resize(std::uint32_t width, std::uint32_t height);
  Result<void> set_view(scene::View view);

  Result<void> advance(bool draw);
  /// Draws the current state.
  Result<void> draw();
  /// The node under (x, y) in clip coordinates; picked() has it until the next call.
  Result<void> pick(double x, double y);
  const std::optional<render::PickedNode>& picked() const { return picked_; }
  /// The state as it is, kept until the next call.
  Result<void> take_snapshot();
  const sim::Snapshot& snapshot() const { return snapshot_; }
  /// The bytes of a file of the present shape: "obj", "ply" or "glb".
  Result<void> export_mesh(const std::string& format);
  const std::vector<std::byte>& exported() const { return exported_; }

  /// What each kernel takes, as JSON: empty where the adapter has no timestamps. The state is as it was then.
  /// Errors  Failure: nothing was simulated, or a frame has one step. DeviceLost.
  Result<void> time_passes();
  const std::string& pass_times() const { return pass_times_; }

  /// What was loaded, as JSON.
  std::string describe() const;
  sim::World* world() { return world_.get(); }
  View* view() { return view_ ? &*view_ : nullptr; }

 private:
  Result<void> build(const std::string& text, const std::string& changes);

  std::unique_ptr<gpu::Device> device_;
  std::string text_;
  std::vector<scene::Override> changes_;
  std::unique_ptr<sim::World> world_;
  Canvas canvas_;
  scene::View shown_ = scene::View::Textured;
  std::optional<View> view_;  // draws from the world's buffers: goes before it
  std::optional<render::PickedNode> picked_;
  sim::Snapshot snapshot_;
  std::vector<std::byte> exported_;
  std::string pass_times_;
};

}  // namespace weft::web
