#include "inputs.hpp"

#include <emscripten/heap.h>

#include <algorithm>
#include <sstream>
#include <string_view>

#include "mesh/read_mesh.hpp"
#include "scene/load.hpp"

namespace weft::web {
namespace {

/// Of a GLB file.
bool has_magic(std::span<const std::byte> bytes) {
  constexpr std::string_view kMagic = "glTF";
  return bytes.size() >= kMagic.size() &&
         std::equal(kMagic.begin(), kMagic.end(), reinterpret_cast<const char*>(bytes.data()));
}

}  // namespace

Result<void> Meshes::add(const std::string& name, std::span<const std::byte> bytes) {
  // A model's plain name is that of a GLB or PLY file, as on the command line.
  const char* kind = has_magic(bytes) ? ".glb" : ".ply";
  const std::string file = name.find('.') == std::string::npos ? name + kind : name;
  WEFT_TRY(mesh, mesh::read_mesh(bytes, file));
  meshes_[name] = std::move(mesh);
  animated_.erase(name);
  if (has_magic(bytes)) animated_.emplace(name, mesh::read_animated_mesh(bytes, file));
  return {};
}

Result<mesh::AnimatedMesh> Meshes::find_animated(const std::string& name) const {
  if (const auto found = animated_.find(name); found != animated_.end()) return found->second;
  if (meshes_.find(name) != meshes_.end()) return no_animation(name);
  return input_error("Mesh %s was not handed over with the scene.", name.c_str());
}

void Meshes::clear() {
  meshes_.clear();
  animated_.clear();
}

Result<mesh::TriangleMesh> Meshes::find(const std::string& name) const {
  if (const auto found = meshes_.find(name); found != meshes_.end()) return found->second;
  return input_error("Mesh %s was not handed over with the scene.", name.c_str());
}

Meshes& meshes() {
  static Meshes all;
  return all;
}

Result<Inputs> read_inputs(const SceneText& source, std::uint64_t bytes_per_node) {
  WEFT_TRY(scene, scene::parse_scene(source.text, source.file, source.changes));
  const auto find_mesh = [](const std::string& name) { return meshes().find(name); };
  const auto find_animated = [](const std::string& name) { return meshes().find_animated(name); };
  WEFT_TRY(assets, load_assets(scene, find_mesh, find_animated));
  WEFT_CHECK(check_memory(scene, assets, bytes_per_node, emscripten_get_heap_max(), "the module's"));
  return Inputs{std::move(scene), std::move(assets)};
}

nlohmann::ordered_json json_of(const Description& description) {
  const std::string& unstable = description.unstable_step;
  return {{"nodes", description.nodes},
          {"triangles", description.triangles},
          {"springs", description.springs},
          {"membranes", description.membranes},
          {"hinges", description.hinges},
          {"slivers", description.slivers},
          {"substeps", description.substeps},
          {"frameSeconds", description.frame_seconds},
          {"stepSeconds", description.step_seconds},
          {"stableStepSeconds", description.stable_step_seconds},
          {"unstableStep", unstable.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(unstable)},
          {"frames", description.frames},
          {"droppedTriangles", description.dropped_triangles}};
}

Result<SceneText> scene_text(std::string text, const std::string& changes) {
  SceneText made{std::move(text), "scene", {}};
  std::istringstream stream(changes);
  for (std::string line; std::getline(stream, line);) {
    WEFT_TRY(change, scene::parse_override(line));
    made.changes.push_back(change);
  }
  return made;
}

}  // namespace weft::web
