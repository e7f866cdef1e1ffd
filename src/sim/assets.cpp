#include "sim/assets.hpp"

#include "mesh/read_mesh.hpp"
#include "scene/load.hpp"

namespace weft::sim {
namespace {

Result<mesh::TriangleMesh> load_placed(const scene::Scene& scene, const std::string& name,
                                       const scene::Transform& transform, const std::string& where,
                                       const std::string& models_folder) {
  auto path = scene::mesh_path(scene, name, models_folder);
  if (!path) return path.error().while_doing("loading " + where);
  auto read = mesh::read_mesh(*path);
  if (!read) return read.error().while_doing("loading " + where);
  mesh::TriangleMesh placed =
      mesh::transformed(*read, transform.scale, transform.rotate, transform.translate);
  if (auto checked = mesh::check_mesh(placed); !checked)
    return checked.error().while_doing("placing " + where);
  return placed;
}

}  // namespace

Result<Assets> load_assets(const scene::Scene& scene, const std::string& models_folder) {
  Assets assets;
  for (const scene::Cloth& cloth : scene.cloths) {
    mesh::TriangleMesh placed;
    if (!cloth.grid) {
      WEFT_TRY(loaded, load_placed(scene, cloth.mesh, cloth.transform, cloth.where, models_folder));
      placed = std::move(loaded);
    }
    assets.cloths.push_back(std::move(placed));
  }
  for (const scene::Collider& collider : scene.colliders) {
    const auto* object = std::get_if<scene::ColliderMesh>(&collider);
    if (object == nullptr) continue;
    WEFT_TRY(placed, load_placed(scene, object->mesh, object->transform, object->where, models_folder));
    assets.dropped_triangles += mesh::drop_degenerate_triangles(placed);
    if (placed.triangles.empty())
      return input_error("%s: mesh %s has no triangle with an area.", object->where.c_str(),
                         object->mesh.c_str());
    assets.objects.push_back(std::move(placed));
  }
  return assets;
}

}  // namespace weft::sim
