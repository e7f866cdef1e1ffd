#include "weft/scene.hpp"

#include "api/scene_content.hpp"
#include "base/file.hpp"
#include "base/json.hpp"
#include "mesh/read_mesh.hpp"
#include "mesh/read_tet_mesh.hpp"
#include "scene/load.hpp"
#include "scene/schema.hpp"

namespace weft {

Result<Inputs> Scene::Content::read(const SceneText& changed) const {
  WEFT_TRY(scene, scene::parse_scene(changed.text, changed.file, changed.changes));
  const auto find_mesh = [&](const std::string& name) -> Result<mesh::TriangleMesh> {
    if (const auto own = meshes.find(name); own != meshes.end()) return own->second;
    WEFT_TRY(path, scene::mesh_path(scene, name, models_folder));
    return mesh::read_mesh(path);
  };
  const auto find_animated = [&](const std::string& name) -> Result<mesh::AnimatedMesh> {
    if (meshes.find(name) != meshes.end()) return no_animation(name);
    WEFT_TRY(path, scene::mesh_path(scene, name, models_folder));
    return mesh::read_animated_mesh(path);
  };
  const auto find_tets = [&](const std::string& name) -> Result<mesh::TetMesh> {
    WEFT_TRY(path, scene::mesh_path(scene, name, models_folder));
    return mesh::read_tet_mesh(path);
  };
  WEFT_TRY(assets, load_assets(scene, find_mesh, find_animated, find_tets));
  return Inputs{std::move(scene), std::move(assets)};
}

Scene::Scene(std::unique_ptr<Content> content) : content_(std::move(content)) {}
Scene::Scene(const Scene& other) : content_(std::make_unique<Content>(*other.content_)) {}
Scene::Scene(Scene&& other) noexcept = default;
Scene& Scene::operator=(const Scene& other) { return *this = Scene(other); }
Scene& Scene::operator=(Scene&& other) noexcept = default;
Scene::~Scene() = default;

Result<Scene> Scene::from_text(std::string json, std::string name) {
  auto content = std::make_unique<Content>();
  content->source.text = std::move(json);
  content->source.file = std::move(name);
  WEFT_CHECK(scene::parse_scene(content->source.text, content->source.file));
  return Scene(std::move(content));
}

Result<Scene> Scene::from_file(const std::string& path) {
  WEFT_TRY(bytes, read_file(path, kMaxJsonBytes));
  return from_text(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), path);
}

Result<void> Scene::set(const std::string& key, const std::string& value) {
  SceneText changed = content_->source;
  changed.changes.push_back({key, value});
  WEFT_CHECK(scene::parse_scene(changed.text, changed.file, changed.changes));
  content_->source = std::move(changed);
  return {};
}

Result<void> Scene::add_mesh(const std::string& name, std::span<const Vec3f> positions,
                             std::span<const Triangle> triangles) {
  mesh::TriangleMesh mesh{{positions.begin(), positions.end()}, {triangles.begin(), triangles.end()}};
  if (auto checked = mesh::check_mesh(mesh); !checked)
    return checked.error().while_doing("adding mesh " + name);
  content_->meshes[name] = std::move(mesh);
  return {};
}

void Scene::set_models_folder(const std::string& folder) { content_->models_folder = folder; }

std::string scene_schema() { return scene::schema_json(); }

}  // namespace weft
