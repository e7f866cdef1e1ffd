// What a page hands over with a scene; a world and a reference read the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "mesh/triangle_mesh.hpp"
#include "method/step_limit.hpp"
#include "model/assets.hpp"
#include "scene/override.hpp"
#include "scene/scene.hpp"

namespace weft::web {

constexpr const char* kSceneName = "scene";  // what messages call the text that a page hands over

/// The meshes that scenes may name. They need no device.
class Meshes {
 public:
  /// Errors  Input: the bytes are no mesh of the format that the name ends in.
  Result<void> add(const std::string& name, std::span<const std::byte> bytes);
  /// Errors  Input: no such mesh was handed over.
  Result<mesh::TriangleMesh> find(const std::string& name) const;
  void clear() { meshes_.clear(); }

 private:
  std::map<std::string, mesh::TriangleMesh> meshes_;
};

/// Those of this module.
Meshes& meshes();

/// A scene and its meshes, read and checked.
struct Inputs {
  scene::Scene scene;
  Assets assets;
};
/// Reads a scene with its changes, and finds its meshes. What would end the module for want of memory is
/// refused, since a failed allocation is a trap: `bytes_per_node` are needed. Errors  Input, Limit.
Result<Inputs> read_inputs(const std::string& text, std::span<const scene::Override> changes,
                           std::uint64_t bytes_per_node);

/// What was loaded, as the JSON that a world and a reference have in common. `Running` is either.
template <class Running>
nlohmann::ordered_json describe(const Running& running, std::size_t nodes, std::size_t triangles,
                                std::size_t dropped_triangles) {
  nlohmann::ordered_json json;
  json["nodes"] = nodes;
  json["triangles"] = triangles;
  json["springs"] = running.spring_count();
  json["substeps"] = running.substeps();
  json["frameSeconds"] = running.scene().time.frame;
  json["stepSeconds"] = running.step();
  json["stableStepSeconds"] = running.plan().limit().largest_step;
  const std::string unstable =
      unstable_step(running.plan().limit(), running.scene().time.frame, running.substeps());
  json["unstableStep"] = unstable.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(unstable);
  json["frames"] = running.scene().time.frames;
  json["droppedTriangles"] = dropped_triangles;
  return json;
}

/// Lines of KEY=JSON. Errors  Usage: a line has no equals sign.
Result<std::vector<scene::Override>> parse_changes(const std::string& lines);

}  // namespace weft::web
