#include "inspect.hpp"

#include <cstdio>

#include "assets.hpp"
#include "cloths.hpp"
#include "model/attachments.hpp"
#include "sim/plan/frame_plan.hpp"
#include "weft/weft.hpp"

namespace weft::cli {
namespace {

Result<void> check_scene(const SceneOptions& options) {
  WEFT_TRY(scene, load(options));
  WEFT_TRY(assets, load_checked_assets(scene));
  WEFT_TRY(model, build_model(scene, assets));
  WEFT_TRY(plan, sim::FramePlan::create(scene, model, assets));
  std::size_t object_triangles = 0;
  for (const mesh::TriangleMesh& object : assets.objects) object_triangles += object.triangles.size();
  std::printf(
      "%s is a valid scene: %zu cloth%s with %zu nodes and %zu triangles, %zu collider%s with %zu "
      "triangles.\n",
      options.path.c_str(), scene.cloths.size(), scene.cloths.size() == 1 ? "" : "s", model.vertex_count(),
      model.triangles.size(), scene.colliders.size(), scene.colliders.size() == 1 ? "" : "s",
      object_triangles);
  std::fputs(cloths_text(scene, model).c_str(), stdout);
  std::fputs(stiffening_text(scene, model, plan.method(), plan.substeps()).c_str(), stdout);
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
