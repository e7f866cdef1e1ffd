#include "inputs.hpp"

#include <emscripten/heap.h>

#include <sstream>

#include "mesh/glb_chunks.hpp"
#include "mesh/read_mesh.hpp"
#include "mesh/read_tet_mesh.hpp"
#include "scene/load.hpp"

namespace weft::web {

Result<void> Meshes::add(const std::string& name, std::span<const std::byte> bytes) {
  if (mesh::names_tet_mesh(name)) {  // read where a scene asks for it: nodes may lie in another file
    files_[name] = std::vector(bytes.begin(), bytes.end());
    return {};
  }
  // A model's plain name is that of a GLB or PLY file, as on the command line.
  const bool is_glb = mesh::begins_as_glb(bytes);
  const bool is_plain = name.find('.') == std::string::npos;
  WEFT_TRY(mesh, mesh::read_mesh(bytes, is_plain ? name + (is_glb ? ".glb" : ".ply") : name));
  meshes_[name] = std::move(mesh);
  files_.erase(name);
  if (is_glb) files_.emplace(name, std::vector(bytes.begin(), bytes.end()));
  return {};
}

Result<mesh::AnimatedMesh> Meshes::find_animated(const std::string& name) const {
  if (const auto file = files_.find(name); file != files_.end())
    return mesh::read_animated_mesh(file->second, name.find('.') == std::string::npos ? name + ".glb" : name);
  if (meshes_.find(name) != meshes_.end()) return no_animation(name);
  return input_error("Mesh %s was not handed over with the scene.", name.c_str());
}

Result<mesh::TetMesh> Meshes::find_tets(const std::string& name) const {
  const std::string beside = mesh::nodes_beside(name);
  for (const std::string& needed : {name, beside})
    if (!needed.empty() && files_.find(needed) == files_.end())
      return input_error("Mesh %s was not handed over with the scene.", needed.c_str());
  return mesh::read_tet_mesh(files_.at(name), name,
                             beside.empty() ? std::span<const std::byte>() : std::span(files_.at(beside)));
}

void Meshes::clear() {
  meshes_.clear();
  files_.clear();
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
  const auto find_tets = [](const std::string& name) { return meshes().find_tets(name); };
  WEFT_TRY(assets, load_assets(scene, find_mesh, find_animated, find_tets));
  WEFT_CHECK(check_memory(scene, assets, bytes_per_node, emscripten_get_heap_max(), "the module's"));
  return Inputs{std::move(scene), std::move(assets)};
}

nlohmann::ordered_json json_of(const Description& description) {
  const auto sentence = [](const std::string& text) {
    return text.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(text);
  };
  return {{"solver", description.solver},
          {"solverReason", sentence(description.solver_reason)},
          {"nodes", description.nodes},
          {"triangles", description.triangles},
          {"springs", description.springs},
          {"membranes", description.membranes},
          {"hinges", description.hinges},
          {"slivers", description.slivers},
          {"tetrahedra", description.tetrahedra},
          {"substeps", description.substeps},
          {"frameSeconds", description.frame_seconds},
          {"stepSeconds", description.step_seconds},
          {"stableStepSeconds", description.stable_step_seconds},
          {"unstableStep", sentence(description.unstable_step)},
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
