#include "scene/load.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/file.hpp"
#include "scene/build.hpp"
#include "scene/check.hpp"

namespace weft::scene {

Result<Scene> parse_scene(std::string_view text, const std::string& file,
                          std::span<const Override> overrides) {
  WEFT_TRY(json, parse_json(text, file));
  for (const Override& change : overrides) WEFT_CHECK(apply(change, json));
  if (Json* format = json.find(scene_type().keys[0].name))  // first: another version has other keys
    WEFT_CHECK(check(*format, *scene_type().keys[0].type, file, scene_type().keys[0].name));
  WEFT_CHECK(check(json, scene_type(), file));
  return build_scene(json, file);
}

Result<Scene> load_scene(const std::string& path, std::span<const Override> overrides) {
  WEFT_TRY(bytes, read_file(path, kMaxJsonBytes));
  return parse_scene({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path, overrides);
}

Result<std::string> mesh_path(const Scene& scene, const std::string& mesh, const std::string& models_folder) {
  const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20; };
  if (mesh.empty() || std::any_of(mesh.begin(), mesh.end(), control))
    return input_error("%s: mesh %s is not a path.", scene.file.c_str(), in_quotes(mesh).c_str());
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
  };
  if (!std::all_of(mesh.begin(), mesh.end(), plain))
    return (std::filesystem::path(scene.file).parent_path() / mesh).string();
  const std::string path = (std::filesystem::path(models_folder) / (mesh + ".ply")).string();
  const std::string animated = (std::filesystem::path(models_folder) / (mesh + ".glb")).string();
  std::error_code ignored;
  if (std::filesystem::exists(animated, ignored)) return animated;
  if (!std::filesystem::exists(path, ignored))
    return input_error(
        "%s: model %s is not at %s; ./dev build makes the models, WEFT_MODELS names their folder.",
        scene.file.c_str(), in_quotes(mesh).c_str(), path.c_str());
  return path;
}

}  // namespace weft::scene
