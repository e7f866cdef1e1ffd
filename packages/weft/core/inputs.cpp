#include "inputs.hpp"

#include <emscripten/heap.h>

#include <sstream>

#include "mesh/read_mesh.hpp"
#include "scene/load.hpp"

namespace weft::web {
Result<void> Meshes::add(const std::string& name, std::span<const std::byte> bytes) {
  // A model's plain name is that of a PLY file, as on the command line.
  const std::string file = name.find('.') == std::string::npos ? name + ".ply" : name;
  WEFT_TRY(mesh, mesh::read_mesh(bytes, file));
  meshes_[name] = std::move(mesh);
  return {};
}

Result<mesh::TriangleMesh> Meshes::find(const std::string& name) const {
  if (const auto found = meshes_.find(name); found != meshes_.end()) return found->second;
  return input_error("Mesh %s was not handed over with the scene.", name.c_str());
}

Meshes& meshes() {
  static Meshes all;
  return all;
}

Result<Inputs> read_inputs(const std::string& text, std::span<const scene::Override> changes,
                           std::uint64_t bytes_per_node) {
  WEFT_TRY(scene, scene::parse_scene(text, kSceneName, changes));
  const auto find_mesh = [](const std::string& name) { return meshes().find(name); };
  WEFT_TRY(assets, load_assets(scene, find_mesh));
  WEFT_CHECK(check_memory(scene, assets, bytes_per_node, emscripten_get_heap_max(), "the module's"));
  return Inputs{std::move(scene), std::move(assets)};
}

Result<std::vector<scene::Override>> parse_changes(const std::string& lines) {
  std::vector<scene::Override> changes;
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) {
    WEFT_TRY(change, scene::parse_override(line));
    changes.push_back(change);
  }
  return changes;
}

}  // namespace weft::web
