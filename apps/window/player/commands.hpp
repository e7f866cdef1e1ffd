// What a user asks of the window beside the keys: scenes, files, recordings. What cannot be done is said.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "player/player.hpp"

namespace weft::window {

/// Where scenes come from and files go.
struct Places {
  std::vector<std::string> scenes;                                 // that are shipped, by name
  std::function<Result<SceneText>(const std::string& name)> find;  // the text of one of them
  std::string out = "out";                                         // folder of what is saved and recorded
};

/// What a mesh that was dropped is to be: the user is asked.
struct MeshQuestion {
  std::shared_ptr<const OwnMesh> mesh;
  Role role = Role::Obstacle;
  double length = kFirstLength;  // of its longest side [m]

  bool has_answer() const { return length >= kLeastLength && length <= kMostLength; }
};

/// Errors of all  DeviceLost; any, where no scene could be shown again.
class Commands {
 public:
  Commands(Player& player, Places places) : player_(player), places_(std::move(places)) {}

  const std::vector<std::string>& scenes() const { return places_.scenes; }
  Result<void> open_shipped(const std::string& name);
  /// Files that were dropped. Of a mesh it is asked first what it shall be.
  Result<void> open_files(const std::vector<std::string>& paths);
  std::optional<MeshQuestion> question;
  /// Opens the mesh as the question has it then, if that is an answer.
  Result<void> answer();

  /// Begins a recording, or ends it. Each has a folder of its own: nothing that was recorded before is written over.
  Result<void> toggle_recording();
  /// The folder of the next one.
  std::string recording_folder() const;
  /// As save_file.
  Result<void> save(const std::string& end);

 private:
  Result<void> open_file(const std::vector<std::string>& paths);

  Player& player_;
  Places places_;
};

}  // namespace weft::window
