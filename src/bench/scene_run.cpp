#include "bench/scene_run.hpp"

#include <vector>

#include "bench/sheet_runs.hpp"
#include "scene/names.hpp"

namespace weft::bench {

Result<SheetRow> measure_scene(gpu::Device& device, const scene::Scene& scene, const Assets& assets,
                               SheetRow begun) {
  WEFT_TRY(run, run_timed(device, scene, assets, std::vector{scene.time.frames}));
  begun.run = std::move(run);
  begun.state_hash = begun.run.states.back().hash();
  if (scene.contact.method != scene::ContactMethod::None) begun.contact = outcome_of(begun.run.totals);
  return begun;
}

Result<void> run_scene(gpu::Device& device, const std::string& name, const scene::Scene& scene,
                       const Assets& assets, const SheetRowDone& done) {
  SheetRow begun;
  begun.object = name;
  begun.variant = scene::name_of(scene.solver.kind);
  Result<SheetRow> measured = measure_scene(device, scene, assets, begun);
  if (measured) {
    measured->variant = scene::name_of(measured->run.solver);
    measured->nodes = measured->simulated_nodes = measured->run.states.back().position.size();
  }
  return report(std::move(measured), begun, done);
}

}  // namespace weft::bench
