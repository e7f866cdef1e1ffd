#include "bench/hanging_sheet.hpp"

#include "scene/load.hpp"

namespace weft::bench {
namespace {

constexpr std::string_view kShortNames[] = {"grid", "mesh", "springs", "blocks"};

}  // namespace

std::span<const std::string_view> hanging_variants() { return kShortNames; }

const char* name_of(Formulation formulation) {
  switch (formulation) {
    case Formulation::Grid:
      return "node_centric, grid";
    case Formulation::Mesh:
      return "node_centric, any mesh";
    case Formulation::SpringCentric:
      return "spring_centric";
    case Formulation::SpringBlocks:
      break;
  }
  return "spring_blocks";
}

Result<Experiment> make_hanging_sheet(std::uint32_t side, Formulation formulation) {
  Experiment made;
  const std::string count = std::to_string(side);
  const std::string shape =
      formulation == Formulation::Mesh
          ? R"("mesh": "sheet.obj", "pins": [{"nodes": [0, )" + std::to_string(side - 1) + "]}]"
          : R"("grid": [)" + count + ", " + count + R"(], "size": [2, 2], "pins": ["top_left", "top_right"])";
  const bool by_node = formulation == Formulation::Grid || formulation == Formulation::Mesh;
  const std::string forces = by_node ? "node_centric" : name_of(formulation);
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

}  // namespace weft::bench
