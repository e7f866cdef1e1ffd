#include "assets.hpp"

#include "common.hpp"
#include "memory.hpp"

namespace weft::cli {

Result<Assets> load_checked_assets(const scene::Scene& scene) {
  WEFT_TRY(assets, load_assets(scene, models_folder()));
  WEFT_CHECK(check_host_memory(scene, assets));
  if (assets.dropped_triangles > 0)
    say("%zu triangles of the colliders have no area and are left out.", assets.dropped_triangles);
  if (assets.merged_vertices > 0)
    say("%zu vertices of the colliders are where others of the same mesh are, and are one with them.",
        assets.merged_vertices);
  return assets;
}

}  // namespace weft::cli
