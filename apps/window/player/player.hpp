// The world that the window shows: which scene is in it, whether it runs, and what is said of it. It knows no window.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "altered.hpp"
#include "gpu/texture.hpp"
#include "player/notice.hpp"
#include "player/own_scene.hpp"
#include "player/pace.hpp"
#include "player/pins.hpp"
#include "player/recording.hpp"
#include "player/scene_values.hpp"
#include "session/session.hpp"
#include "weft/report.hpp"

namespace weft::window {

/// What is to be shown.
struct Wanted {
  std::string name;                     // of files that are saved: the scene's name, or that of its file
  SceneText scene;                      // with what the command line changes in it
  Changes set;                          // what the panel changes
  std::shared_ptr<const OwnMesh> mesh;  // that the scene calls kOwnMesh; null: its meshes are files
};

/// Reads a scene and its meshes, and checks them.
using Reader = std::function<Result<Inputs>(const SceneText& scene, const OwnMesh* mesh)>;

/// New values of keys, as JSON; none: as the scene has it.
using Edits = std::map<std::string, std::optional<std::string>>;

class Player {
 public:
  /// `build`: as saved states name what they come from.
  Player(Reader read, std::string build) : read_(std::move(read)), build_(std::move(build)) {}

  /// Opens the device, and a canvas of this size to draw on. Errors  those of Session::open and resize.
  Result<void> begin(const gpu::DeviceOptions& options, std::uint32_t width, std::uint32_t height,
                     scene::View view);
  /// Shows a scene. Errors  those of scene::parse_scene, with nothing changed. Those of Session::load; the scene before
  /// is then shown again from its start, if there was one.
  Result<void> open(Wanted wanted);
  /// Goes on from the bytes of a saved state. Errors  those of Session::open_state, with nothing changed.
  Result<void> open_state(const std::string& path);
  bool has_world() { return session_.world() != nullptr; }
  const Wanted& shown() const { return *loaded_; }
  const Description& facts() const { return facts_; }
  /// What contact and solver have altered so far, a sentence each.
  std::vector<std::string> remarks();

  /// Simulates what is due after so much more time [s], and draws it. With `counted` a frame is due each time.
  /// Errors  DeviceLost; others are said, and end the playing.
  Result<void> tick(double seconds, bool counted);
  /// How long until a frame is due [s]; infinite where none will be.
  double until_due() const;
  double dropped_seconds() const { return pace_.dropped(); }
  bool playing() const { return playing_; }
  void play(bool on);
  Result<void> step();
  Result<void> reset();
  /// Waits for all frames. Errors  as sim::World::finish.
  Result<std::string> state_hash();

  /// A camera that was turned stays. Errors  those of CanvasView::resize.
  Result<void> resize(std::uint32_t width, std::uint32_t height);
  const gpu::Texture& canvas() const { return canvas_; }
  /// A view that cannot be shown is refused in a sentence. Errors  DeviceLost.
  Result<void> set_view(scene::View view);
  scene::View view() const { return session_.shown(); }
  /// What X goes back to.
  scene::View before_wireframe() const { return before_wireframe_; }
  /// Why a view cannot be shown; empty: it can.
  std::string refusal(scene::View view);
  view::CanvasView& look() { return *session_.canvas_view(); }
  void set_camera(const render::Camera& camera);
  void reset_camera() { set_camera(home_); }

  /// Changes keys while the cloth moves, or else by opening the scene again. What is refused is said.
  /// Errors  DeviceLost; those of open, where no scene could be shown again.
  Result<void> change_live(const Edits& edits);
  Result<void> change(const Edits& edits);
  const SceneValues& values() const { return values_; }

  /// Records into this folder from now on. Errors  those of Recording::begin.
  Result<void> record(const std::string& folder);
  /// Where all is; the sentence says so. Errors  Failure: the disk is full.
  Result<std::string> stop_recording();
  const std::optional<Recording>& recording() const { return recording_; }

  /// Says what has gone wrong. Errors  DeviceLost; any, where no world is shown.
  Result<void> said(const Result<void>& done);
  Notice notice;
  /// Pins what is under a rectangle of the picture, or lets it go; why it cannot is said. Errors  DeviceLost.
  Result<void> pin_within(const render::PickArea& area);
  std::optional<render::PickArea> drawn_area;  // the rectangle that the pointer draws

  sim::World& world() { return *session_.world(); }
  gpu::Device& device() { return session_.device(); }
  Session& session() { return session_; }
  Pins& pins() { return pins_; }
  const std::string& build() const { return build_; }

 private:
  Result<void> load(const Wanted& wanted);
  /// Tells the world what a key is now, and those in whose place it stands.
  Result<void> tell(const std::string& key);
  /// Where the camera stands until it is turned: such that the cloth is in the picture.
  void find_home();
  Result<void> make_canvas(std::uint32_t width, std::uint32_t height);
  /// Sews and tears what is due before the next frame.
  Result<void> change_mesh();
  Result<void> simulate_and_draw();
  /// The same as said, and ends the playing.
  Result<void> stopped(const Result<void>& done);
  void count_anew();

  Reader read_;
  std::string build_;
  Session session_;
  gpu::Texture canvas_;
  std::optional<Wanted> loaded_;
  SceneValues values_;
  Description facts_;
  render::Camera home_;
  scene::View before_wireframe_ = scene::View::Textured;
  Pins pins_{session_};
  cli::Altered altered_;
  std::uint64_t truncated_ = 0;
  bool playing_ = false, stale_ = true;
  Pace pace_;
  std::optional<Recording> recording_;
};

}  // namespace weft::window
