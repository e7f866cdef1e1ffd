#include "bench/hanging.hpp"

#include "bench/drawn_frames.hpp"
#include "scene/load.hpp"

namespace weft::bench {
namespace {

enum class Formulation { Grid, Mesh, SpringCentric };
constexpr Formulation kFormulations[] = {Formulation::Grid, Formulation::Mesh, Formulation::SpringCentric};
constexpr std::string_view kShortNames[] = {"grid", "mesh", "springs"};  // as a selection has them
constexpr const char* kNames[] = {"node_centric, grid", "node_centric, any mesh", "spring_centric"};

/// The sheet as a grid, or as a mesh of the same nodes.
struct Experiment {
  scene::Scene scene;
  sim::Assets assets;
};

Result<Experiment> make_experiment(std::uint32_t side, Formulation formulation) {
  Experiment made;
  const std::string count = std::to_string(side);
  const std::string shape =
      formulation == Formulation::Mesh
          ? R"("mesh": "sheet.obj", "pins": [{"nodes": [0, )" + std::to_string(side - 1) + "]}]"
          : R"("grid": [)" + count + ", " + count + R"(], "size": [2, 2], "pins": ["top_left", "top_right"])";
  const std::string forces = formulation == Formulation::SpringCentric ? "spring_centric" : "node_centric";
  WEFT_TRY(scene, scene::parse_scene(R"({"format": "weft-scene/1", "contact": {"method": "none"},
    "solver": {"kind": "mass_spring", "forces": ")" +
                                         forces + R"("}, "cloths": [{)" + shape +
                                         R"(, "density": 0.2, "damping": 0.001,
    "stiffness": {"structural": 5000, "shear": 2000, "bend": 500}}]})",
                                     "bench hanging"));
  made.scene = std::move(scene);
  made.assets.cloths.resize(1);
  if (formulation == Formulation::Mesh) {
    const mesh::Grid grid{side, side, 2, 2};
    mesh::TriangleMesh& sheet = made.assets.cloths[0];
    for (std::uint32_t j = 0; j < side; ++j)
      for (std::uint32_t i = 0; i < side; ++i) {
        const mesh::RestPoint p = mesh::rest_point(grid, i, j);
        sheet.positions.push_back(Vec3d{p.x - 1, 1 - p.y, 0}.to<float>());
      }
    sheet.triangles = mesh::grid_triangles(grid);
  }
  return made;
}

Result<Row> measure(gpu::Device& device, Row row, Formulation formulation, bool quick) {
  WEFT_CHECK(sim::check_node_count(static_cast<std::uint64_t>(row.side) * row.side, device));
  WEFT_TRY(experiment, make_experiment(row.side, formulation));
  const scene::Scene any_step = experiment.scene;
  const std::uint32_t steps = quick ? 16 : 256;
  WEFT_TRY(substeps, fix_step(experiment.scene, experiment.assets, steps));
  {
    const std::uint64_t before = device.allocated_bytes();
    WEFT_TRY(world, sim::World::create(device, experiment.scene, experiment.assets));
    for (int frame = 0; frame < 2; ++frame) WEFT_CHECK(world->advance_frame());
    WEFT_CHECK(world->finish());
    WEFT_TRY(snapshot, world->snapshot());
    describe(row, *world, substeps);
    row.state_hash = snapshot.hash();
    WEFT_CHECK(time_row(row, *world, quick ? 300 : 500, 5));
    row.gpu_bytes = device.allocated_bytes() - before;
  }
  WEFT_TRY(frame, time_drawn_frames(device, any_step, experiment.assets, nullptr, quick ? 100 : 500, 5));
  row.paper_frame = frame;
  return row;
}

}  // namespace

std::span<const std::string_view> hanging_variants() { return kShortNames; }

Result<void> run_hanging(gpu::Device& device, const Selection& selection,
                         const std::function<Result<void>(const Row&)>& done) {
  std::vector<std::uint32_t> sides = selection.sides;
  if (sides.empty() && selection.quick) sides = {64, 100, 128};
  if (sides.empty()) sides = {64, 100, 128, 200, 256, 400, 512, 800, 2048};
  for (const std::uint32_t side : sides)
    for (std::size_t k = 0; k < std::size(kFormulations); ++k) {
      if (!selection.has_variant(kShortNames[k])) continue;
      Row begun;
      begun.object = "none";
      begun.variant = kNames[k];
      begun.side = side;
      WEFT_TRY(row, or_skipped(measure(device, begun, kFormulations[k], selection.quick), begun));
      WEFT_CHECK(done(row));
    }
  return {};
}

}  // namespace weft::bench
