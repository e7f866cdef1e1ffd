#include "method/mass_spring/fabric_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "element/membrane/membranes.hpp"
#include "method/mass_spring/spectrum.hpp"
#include "model/fabric.hpp"

namespace weft {
namespace {

/// A sheet that is free, with its masses.
struct Part {
  std::vector<Vec3d> position;  // [m]
  std::vector<double> mass;     // [kg]
  std::vector<mesh::Triangle> triangles;
  Vec3d warp;
  std::vector<Vec3d> warps{};

  RestSheet rest() const { return {position, triangles, warp, {}, {}, warps}; }
};

/// The pieces that a cloth is cut from. Sewn together they have no larger eigenvalue, but for bending across seams.
Part cut_of(const Model& model, const Body& body) {
  const CutPattern& pattern = *body.pattern;
  std::vector<double> parts(body.vertex_count);
  for (const std::uint32_t node : pattern.node) ++parts[node];
  Part part{pattern.position, {}, pattern.triangles, body.warp, body.warps};
  for (const std::uint32_t node : pattern.node)
    part.mass.push_back(model.mass[body.first_vertex + node] / parts[node]);
  return part;
}

Part part_of(const Model& model, const Body& body) {
  if (body.grid) {
    const mesh::Grid grid = stiffest_grid(*body.grid);
    Part part{{}, grid_masses(model, body, grid), mesh::grid_triangles(grid), {1, 0, 0}};
    for (std::uint32_t j = 0; j < grid.ny; ++j)
      for (std::uint32_t i = 0; i < grid.nx; ++i) {
        const mesh::RestPoint point = mesh::rest_point(grid, i, j);
        part.position.push_back({point.x, point.y, 0});
      }
    return part;
  }
  if (body.pattern) return cut_of(model, body);
  const FabricSheet sheet = fabric_sheet(model, body);
  const auto first = model.mass.begin() + body.first_vertex;
  return {sheet.position, {first, first + body.vertex_count}, sheet.triangles, sheet.warp, sheet.warps};
}

/// The stiffness of a sheet at rest. All energies of membranes agree there, and what damping does by velocities after a
/// delay of 1 s is what they do by ways.
class RestStiffness {
 public:
  RestStiffness(const Part& part, const scene::Fabric& fabric, std::optional<ElementKind> kind)
      : part_(part),
        kind_(kind),
        membranes_(membrane::Membranes::of(part.rest(),
                                           {membrane::Energy::Green, membrane_law(fabric).stiffness, 1})),
        plate_(hinge::build_plate(part.rest(), bending_law(fabric))) {}

  /// y = M^-1/2 K M^-1/2 x
  void apply(const std::vector<Vec3d>& x, std::vector<Vec3d>& y) const {
    std::vector<Vec3d> way(x.size());
    for (std::size_t n = 0; n < x.size(); ++n) way[n] = x[n] / std::sqrt(part_.mass[n]);
    std::fill(y.begin(), y.end(), Vec3d{});
    if (kind_ != ElementKind::Hinge) membranes_.add_damping_forces(part_.position, way, y);
    if (kind_ != ElementKind::Membrane) {
      const std::vector<double> bends = hinge::bend_rates(plate_, part_.position, way);
      hinge::add_forces(plate_, hinge::moments(plate_, bends), part_.position, y);
    }
    for (std::size_t n = 0; n < y.size(); ++n) y[n] = y[n] / -std::sqrt(part_.mass[n]);
  }

 private:
  const Part& part_;
  std::optional<ElementKind> kind_;  // none: both
  membrane::Membranes membranes_;
  hinge::Plate plate_;
};

NetworkSpectrum spectrum_of(const Model& model, const Body& body, std::optional<ElementKind> kind) {
  const Part part = part_of(model, body);
  const RestStiffness stiffness(part, *body.fabric, kind);
  const double largest = largest_eigenvalue(
      [&](const std::vector<Vec3d>& x, std::vector<Vec3d>& y) { stiffness.apply(x, y); }, part.mass.size());
  return {largest, body.fabric->damping * largest};
}

}  // namespace

NetworkSpectrum find_fabric_spectrum(const Model& model, const Body& body) {
  return spectrum_of(model, body, std::nullopt);
}

NetworkSpectrum find_fabric_spectrum(const Model& model, const Body& body, ElementKind kind) {
  return spectrum_of(model, body, kind);
}

}  // namespace weft
