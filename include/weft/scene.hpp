#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "weft/result.hpp"
#include "weft/vec.hpp"

namespace weft {

/// Three vertices of a triangle, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// What to simulate: the JSON of docs/scene.md, changes to it, and the meshes that it names. A value: a world is made
/// from it and keeps nothing of it. A Scene that was moved from may only be assigned to or destroyed.
class Scene {
 public:
  /// A scene from its JSON. `name` stands in messages; relative paths of meshes start at its folder.
  /// Errors  Input: not JSON, or not a scene; the path of the key, its value and the limit are in the message.
  static Result<Scene> from_text(std::string json, std::string name = "scene");
  /// A scene from a file. Errors  Input: as from_text, or the file cannot be read.
  static Result<Scene> from_file(const std::string& path);

  Scene(const Scene& other);
  Scene(Scene&& other) noexcept;
  Scene& operator=(const Scene& other);
  Scene& operator=(Scene&& other) noexcept;
  ~Scene();

  /// Sets the value at a dotted key: set("cloths.0.grid", "[128, 128]"). `value` is JSON; a bare word is a text.
  /// Errors  Input: the scene would not be valid; it stays as it was.
  Result<void> set(const std::string& key, const std::string& value);

  /// A mesh that the scene may name, as "mesh" of a cloth or a collider; one of the same name is replaced. Meshes that
  /// were not added are read from files when a world is made.
  /// Reads   positions [m], before the scene's transform; triangles.
  /// Errors  Input: no triangle, an index beyond the vertices, a coordinate that is not finite.
  Result<void> add_mesh(const std::string& name, std::span<const Vec3f> positions,
                        std::span<const Triangle> triangles);
  /// The folder of the meshes that a scene names without a path: NAME is FOLDER/NAME.ply. None at first.
  void set_models_folder(const std::string& folder);

 private:
  friend class World;
  struct Content;
  explicit Scene(std::unique_ptr<Content> content);
  std::unique_ptr<Content> content_;
};

/// The JSON Schema (2020-12) of scenes, for editors and for checks without weft.
std::string scene_schema();

}  // namespace weft
