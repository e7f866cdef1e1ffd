#include "inspect.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

#include "assets.hpp"
#include "base/words.hpp"
#include "cloths.hpp"
#include "contact/rules/rigid_body.hpp"
#include "model/attachments.hpp"
#include "sim/plan/frame_plan.hpp"
#include "weft/weft.hpp"

namespace weft::cli {
namespace {

std::string cloths_and_bodies(const scene::Scene& scene) {
  const auto bodies = static_cast<std::size_t>(std::count_if(
      scene.cloths.begin(), scene.cloths.end(), [](const scene::Cloth& c) { return c.solid.has_value(); }));
  const std::size_t cloths = scene.cloths.size() - bodies;
  if (bodies == 0) return counted(cloths, "cloth", "cloths");
  return (cloths == 0 ? "" : counted(cloths, "cloth", "cloths") + " and ") +
         counted(bodies, "body", "bodies");
}

Result<void> check_scene(const SceneOptions& options) {
  WEFT_TRY(scene, load(options));
  WEFT_TRY(assets, load_checked_assets(scene));
  WEFT_TRY(model, build_model(scene, assets));
  WEFT_TRY(plan, sim::FramePlan::create(scene, model, assets));
  std::size_t object_triangles = 0;
  for (const mesh::TriangleMesh& object : assets.objects) object_triangles += object.triangles.size();
  std::printf("%s is a valid scene: %s with %zu nodes and %zu triangles, %s with %zu triangles.\n",
              options.path.c_str(), cloths_and_bodies(scene).c_str(), model.vertex_count(),
              model.triangles.size(), counted(scene.colliders.size(), "collider", "colliders").c_str(),
              object_triangles);
  std::fputs(cloths_text(scene, model).c_str(), stdout);
  const std::vector<ColliderSolid> solids = solids_of(scene, assets.objects, assets.object_colliders);
  for (std::size_t c = 0; c < solids.size(); ++c)
    if (solids[c].rigid())
      std::printf(
          "  colliders[%zu] is a rigid body of %.4g kg, with %.4g, %.4g and %.4g kg m² about its own axes.\n",
          c, solids[c].mass, solids[c].inertia.x, solids[c].inertia.y, solids[c].inertia.z);
  std::fputs(stiffening_text(scene, model, plan.method(), plan.substeps()).c_str(), stdout);
  std::fputs(creeping_text(scene, plan.method()).c_str(), stdout);
  return {};
}

}  // namespace

int check(const SceneOptions& options) {
  const Result<void> result = check_scene(options);
  return result ? 0 : report(result.error());
}

int list_adapters() {
  const auto adapters = weft::adapters();
  if (!adapters) return report(adapters.error());
  if (adapters->empty())
    return report(
        make_error(ErrorKind::NoAdapter,
                   "No WebGPU adapter was found: this machine has no Vulkan, Metal or D3D12 driver."));
  for (const AdapterInfo& adapter : *adapters)
    std::printf("%s (%s, %s, %s)\n", adapter.name.c_str(), adapter.type.c_str(), adapter.backend.c_str(),
                adapter.driver.c_str());
  return 0;
}

int print_schema() {
  std::fputs(scene_schema().c_str(), stdout);
  return 0;
}

}  // namespace weft::cli
