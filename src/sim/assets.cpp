#include "sim/assets.hpp"

#include "mesh/read_mesh.hpp"
#include "scene/load.hpp"

namespace weft::sim {
namespace {

Result<mesh::TriangleMesh> load_placed(const MeshReader& read, const std::string& name,
                                       const scene::Transform& transform, const std::string& where) {
  auto loaded = read(name);
  if (!loaded) return loaded.error().while_doing("loading " + where);
  mesh::TriangleMesh placed =
      mesh::transformed(*loaded, transform.scale, transform.rotate, transform.translate);
  if (auto checked = mesh::check_mesh(placed); !checked)
    return checked.error().while_doing("placing " + where);
  return placed;
}

}  // namespace

Result<Assets> load_assets(const scene::Scene& scene, const std::string& models_folder) {
  return load_assets(scene, [&](const std::string& name) -> Result<mesh::TriangleMesh> {
    WEFT_TRY(path, scene::mesh_path(scene, name, models_folder));
    return mesh::read_mesh(path);
  });
}

Result<Assets> load_assets(const scene::Scene& scene, const MeshReader& read) {
  Assets assets;
  for (const scene::Cloth& cloth : scene.cloths) {
    mesh::TriangleMesh placed;
    if (!cloth.grid) {
      WEFT_TRY(loaded, load_placed(read, cloth.mesh, cloth.transform, cloth.where));
      placed = std::move(loaded);
    }
    assets.cloths.push_back(std::move(placed));
  }
  for (const scene::Collider& collider : scene.colliders) {
    const auto* object = std::get_if<scene::ColliderMesh>(&collider);
    if (object == nullptr) continue;
    WEFT_TRY(placed, load_placed(read, object->mesh, object->transform, object->where));
    assets.dropped_triangles += mesh::drop_degenerate_triangles(placed);
    if (placed.triangles.empty())
      return input_error("%s: mesh %s has no triangle with an area.", object->where.c_str(),
                         object->mesh.c_str());
    assets.objects.push_back(std::move(placed));
  }
  return assets;
}

std::uint64_t node_count(const scene::Scene& scene, const Assets& assets) {
  std::uint64_t nodes = 0;
  for (const scene::Cloth& cloth : scene.cloths)
    if (cloth.grid) nodes += std::uint64_t{cloth.grid->nx} * cloth.grid->ny;
  for (const mesh::TriangleMesh& cloth : assets.cloths) nodes += cloth.positions.size();
  return nodes;
}

}  // namespace weft::sim
