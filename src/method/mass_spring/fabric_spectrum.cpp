#include "method/mass_spring/fabric_spectrum.hpp"

#include <algorithm>
#include <cmath>

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

  RestSheet rest() const { return {position, triangles, warp, {}}; }
};

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
  const FabricSheet sheet = fabric_sheet(model, body);
  const auto first = model.mass.begin() + body.first_vertex;
  return {sheet.position, {first, first + body.vertex_count}, sheet.triangles, sheet.warp};
}

/// A triangle at rest, with the directions of its axes.
struct Membrane {
  mesh::Triangle nodes;
  membrane::Rest rest;
  membrane::Axes axes;
};

/// The stiffness of a sheet at rest: all energies of membranes agree there.
class Stiffnesses {
 public:
  Stiffnesses(const Part& part, const scene::Fabric& fabric)
      : part_(part),
        law_(membrane_law(fabric)),
        plate_(hinge::build_plate(part.rest(), bending_law(fabric))) {
    for (const mesh::Triangle& nodes : part.triangles) {
      const membrane::Corners corners = at(nodes, part.position);
      const auto rest = membrane::Rest::of(places_of(corners, part.warp));
      membranes_.push_back({nodes, rest, membrane::deformation(rest, corners)});
    }
    for (const hinge::Hinge& hinge : plate_.hinges)
      slopes_.push_back(hinge::angle_slope(hinge::corners_of(hinge, part.position)));
  }

  /// y = M^-1/2 K M^-1/2 x
  void apply(const std::vector<Vec3d>& x, std::vector<Vec3d>& y) const {
    std::vector<Vec3d> moved(x.size());
    for (std::size_t n = 0; n < x.size(); ++n) moved[n] = x[n] / std::sqrt(part_.mass[n]);
    std::fill(y.begin(), y.end(), Vec3d{});
    for (const Membrane& one : membranes_) stretch(one, moved, y);
    bend(moved, y);
    for (std::size_t n = 0; n < y.size(); ++n) y[n] = y[n] / std::sqrt(part_.mass[n]);
  }

 private:
  static membrane::Corners at(const mesh::Triangle& nodes, const std::vector<Vec3d>& x) {
    return {x[nodes[0]], x[nodes[1]], x[nodes[2]]};
  }

  void stretch(const Membrane& one, const std::vector<Vec3d>& x, std::vector<Vec3d>& y) const {
    const membrane::Axes change = membrane::deformation(one.rest, at(one.nodes, x));
    const membrane::Law law{membrane::Energy::Green, law_.stiffness, 1};
    const membrane::Corners forces =
        membrane::forces(one.rest, membrane::damping_stress(law, one.axes, change));
    for (std::size_t i = 0; i < 3; ++i) y[one.nodes[i]] -= forces[i];
  }

  void bend(const std::vector<Vec3d>& x, std::vector<Vec3d>& y) const {
    std::vector<double> bends;
    for (std::size_t h = 0; h < slopes_.size(); ++h) {
      const hinge::Corners corners = hinge::corners_of(plate_.hinges[h], x);
      double change = 0;
      for (std::size_t i = 0; i < 4; ++i) change += dot(slopes_[h][i], corners[i]);
      bends.push_back(change);
    }
    const std::vector<double> moments = hinge::moments(plate_, bends);
    for (std::size_t h = 0; h < slopes_.size(); ++h)
      for (std::size_t i = 0; i < 4; ++i) y[plate_.hinges[h].nodes[i]] += moments[h] * slopes_[h][i];
  }

  const Part& part_;
  membrane::Law law_;
  hinge::Plate plate_;
  std::vector<Membrane> membranes_;
  std::vector<hinge::Corners> slopes_;
};

}  // namespace

NetworkSpectrum find_fabric_spectrum(const Model& model, const Body& body) {
  const Part part = part_of(model, body);
  const Stiffnesses stiffness(part, *body.fabric);
  const double largest = largest_eigenvalue(
      [&](const std::vector<Vec3d>& x, std::vector<Vec3d>& y) { stiffness.apply(x, y); }, part.mass.size());
  return {largest, body.fabric->damping * largest};
}

}  // namespace weft
