#include "player/commands.hpp"

#include <filesystem>

#include "base/file.hpp"
#include "player/dropped.hpp"
#include "player/saved_file.hpp"

namespace weft::window {

Result<void> Commands::open_shipped(const std::string& name) {
  return player_.said([&]() -> Result<void> {
    Wanted wanted;
    wanted.name = name;
    WEFT_SET(wanted.scene, places_.find(name));
    return player_.open(std::move(wanted));
  }());
}

Result<void> Commands::open_files(const std::vector<std::string>& paths) {
  return player_.said(open_file(paths));
}

Result<void> Commands::open_file(const std::vector<std::string>& paths) {
  WEFT_TRY(dropped, dropped_file(paths));
  if (dropped.kind == DroppedKind::State) return player_.open_state(dropped.path);
  if (dropped.kind == DroppedKind::Mesh) {
    WEFT_TRY(mesh, read_own_mesh(dropped.path));
    const Role role = mesh.may_be(Role::Obstacle) ? Role::Obstacle : Role::Cloth;
    question = MeshQuestion{std::make_shared<const OwnMesh>(std::move(mesh)), role};
    return {};
  }
  WEFT_TRY(bytes, read_file(dropped.path, kMaxJsonBytes));
  Wanted wanted;
  wanted.name = std::filesystem::path(dropped.path).stem().string();
  wanted.scene.text.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  wanted.scene.file = dropped.path;
  return player_.open(std::move(wanted));
}

Result<void> Commands::answer() {
  if (!question || !question->has_answer()) return {};
  const MeshQuestion asked = *question;
  question.reset();
  Wanted wanted;
  wanted.name = asked.mesh->name.substr(0, asked.mesh->name.find('.'));
  wanted.scene.text = scene_of_mesh(*asked.mesh, asked.role, asked.length);
  wanted.scene.file = asked.mesh->name;
  wanted.mesh = asked.mesh;
  return player_.said(player_.open(std::move(wanted)));
}

std::string Commands::recording_folder() const {
  const std::filesystem::path place = std::filesystem::path(places_.out) / player_.shown().name;
  std::filesystem::path folder = place;
  std::error_code ignored;
  for (int number = 2; std::filesystem::exists(folder, ignored); ++number)
    folder = place.string() + "-" + std::to_string(number);
  return folder.string();
}

Result<void> Commands::toggle_recording() {
  if (!player_.recording()) return player_.said(player_.record(recording_folder()));
  return player_.said([&]() -> Result<void> {
    WEFT_TRY(sentence, player_.stop_recording());
    player_.notice.say(sentence, Tone::Plain);
    return {};
  }());
}

Result<void> Commands::save(const std::string& end) {
  return player_.said([&]() -> Result<void> {
    WEFT_TRY(path, save_file(player_, places_.out, end));
    player_.notice.say("Saved " + path + ".", Tone::Plain);
    return {};
  }());
}

}  // namespace weft::window
