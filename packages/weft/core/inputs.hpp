// What a page hands over with a scene; a world and a reference read the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "mesh/triangle_mesh.hpp"
#include "scene/override.hpp"
#include "scene/scene.hpp"
#include "sim/assets.hpp"

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

/// Refuses what would end the module for want of memory: a failed allocation is a trap. Errors  Limit.
Result<void> check_room(const scene::Scene& scene, const sim::Assets& assets, std::uint64_t bytes_per_node);

/// Lines of KEY=JSON. Errors  Usage: a line has no equals sign.
Result<std::vector<scene::Override>> parse_changes(const std::string& lines);

}  // namespace weft::web
