// The inputs that a page passes with a scene; a world and a reference read the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "mesh/animated_mesh.hpp"
#include "mesh/triangle_mesh.hpp"
#include "scene/override.hpp"
#include "scene/scene.hpp"
#include "session/session.hpp"
#include "weft/report.hpp"

namespace weft::web {

/// The meshes that scenes may name. They need no device.
class Meshes {
 public:
  /// Errors  Input: the bytes are no mesh of the format that the name ends in.
  Result<void> add(const std::string& name, std::span<const std::byte> bytes);
  /// Errors  Input: no such mesh was handed over.
  Result<mesh::TriangleMesh> find(const std::string& name) const;
  /// What it animates. Errors  Input: no such mesh was handed over, or it is no GLB file.
  Result<mesh::AnimatedMesh> find_animated(const std::string& name) const;
  /// Of a file of tetrahedra, whose nodes may be in another.
  Result<mesh::TetMesh> find_tets(const std::string& name) const;
  void clear();

 private:
  std::map<std::string, mesh::TriangleMesh> meshes_;
  std::map<std::string, std::vector<std::byte>> files_;  // of those from GLB files, for their animations
};

/// Those of this module.
Meshes& meshes();

/// Reads a scene with its changes, and finds its meshes. What would end the module for want of memory is
/// refused, since a failed allocation is a trap: `bytes_per_node` are needed. Errors  Input, Limit.
Result<Inputs> read_inputs(const SceneText& source, std::uint64_t bytes_per_node);

/// Facts of the loaded scene, in the package's names.
nlohmann::ordered_json json_of(const Description& description);

/// A page's inputs: a scene, and changes as lines of KEY=JSON. Errors  Usage: a line has no equals sign.
Result<SceneText> scene_text(std::string text, const std::string& changes);

}  // namespace weft::web
