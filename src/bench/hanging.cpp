#include "bench/hanging.hpp"

#include "scene/load.hpp"

namespace weft::bench {
namespace {

enum class Formulation { Grid, Mesh, SpringCentric };

const char* name_of(Formulation formulation) {
  switch (formulation) {
    case Formulation::Grid:
      return "node_centric, grid";
    case Formulation::Mesh:
      return "node_centric, any mesh";
    case Formulation::SpringCentric:
      break;
  }
  return "spring_centric";
}

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

Result<Row> measure(gpu::Device& device, std::uint32_t side, Formulation formulation, bool quick) {
  WEFT_TRY(experiment, make_experiment(side, formulation));
  const std::uint32_t steps = quick ? 16 : 256;
  WEFT_TRY(substeps, fix_step(experiment.scene, experiment.assets, steps));
  WEFT_TRY(world, sim::World::create(device, experiment.scene, experiment.assets));
  for (int frame = 0; frame < 2; ++frame) WEFT_CHECK(world->advance_frame());
  WEFT_CHECK(world->finish());
  WEFT_TRY(snapshot, world->snapshot());
  Row row = describe(*world, substeps);
  row.object = "none";
  row.variant = name_of(formulation);
  row.state_hash = snapshot.hash();
  WEFT_TRY(timing, time_steps(*world, quick ? 300 : 500, 5));
  row.ms_per_step = timing.median;
  row.ms_per_step_min = timing.least;
  row.real_time_factor = 1000.0 / 60 / (timing.median * substeps);
  return row;
}

}  // namespace

Result<void> run_hanging(gpu::Device& device, bool quick,
                         const std::function<Result<void>(const Row&)>& done) {
  const std::vector<std::uint32_t> sides =
      quick ? std::vector<std::uint32_t>{64, 100, 128}
            : std::vector<std::uint32_t>{64, 100, 128, 200, 256, 400, 512, 800, 2048};
  for (const std::uint32_t side : sides)
    for (const Formulation formulation : {Formulation::Grid, Formulation::Mesh, Formulation::SpringCentric}) {
      auto row = measure(device, side, formulation, quick);
      if (!row) {
        if (row.error().kind != ErrorKind::Limit && row.error().kind != ErrorKind::OutOfMemory)
          return row.error();
        Row skipped;
        skipped.object = "none";
        skipped.variant = name_of(formulation);
        skipped.nodes = static_cast<std::uint64_t>(side) * side;
        skipped.skipped = row.error().message;
        row = skipped;
      }
      WEFT_CHECK(done(*row));
    }
  return {};
}

}  // namespace weft::bench
