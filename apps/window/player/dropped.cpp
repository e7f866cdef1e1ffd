#include "player/dropped.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace weft::window {
namespace {

std::string end_of(const std::string& path) {
  std::string end = std::filesystem::path(path).extension().string();
  std::transform(end.begin(), end.end(), end.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return end;
}

std::string name_of(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace

Result<Dropped> dropped_file(const std::vector<std::string>& paths) {
  if (paths.empty()) return input_error("Nothing that was dropped is a file.");
  std::vector<std::string> scenes;
  for (const std::string& path : paths)
    if (end_of(path) == ".json") scenes.push_back(path);
  if (scenes.size() > 1)
    return input_error("Open one scene at a time: %s and %s are two.", name_of(scenes[0]).c_str(),
                       name_of(scenes[1]).c_str());
  if (scenes.size() == 1) return Dropped{DroppedKind::Scene, scenes[0]};
  if (paths.size() > 1)
    return input_error("Open one mesh at a time, or a scene: these are %zu files.", paths.size());
  return Dropped{end_of(paths[0]) == ".weft" ? DroppedKind::State : DroppedKind::Mesh, paths[0]};
}

}  // namespace weft::window
