#include "assets.hpp"

#include "common.hpp"
#include "memory.hpp"

namespace weft::cli {
namespace {

Result<Assets> checked(const scene::Scene& scene, Assets assets) {
  WEFT_CHECK(check_host_memory(scene, assets));
  if (assets.dropped_triangles > 0)
    say("%zu triangles of the colliders have no area and are left out.", assets.dropped_triangles);
  if (assets.merged_vertices > 0)
    say("%zu vertices of the colliders are where others of the same mesh are, and are one with them.",
        assets.merged_vertices);
  return assets;
}

}  // namespace

Result<Assets> load_checked_assets(const scene::Scene& scene) {
  WEFT_TRY(assets, load_assets(scene, models_folder()));
  return checked(scene, std::move(assets));
}

Result<Assets> load_checked_assets(const scene::Scene& scene, const std::string& name,
                                   const mesh::TriangleMesh& mesh) {
  const MeshReader read = [&](const std::string& called) -> Result<mesh::TriangleMesh> {
    if (called == name) return mesh;
    return input_error("The scene has the mesh %s alone.", name.c_str());
  };
  WEFT_TRY(assets, load_assets(scene, read));
  return checked(scene, std::move(assets));
}

}  // namespace weft::cli
