#include "method/vbd/reference/fabric_descent.hpp"

#include <algorithm>

#include "element/incidence.hpp"

namespace weft::reference {
namespace {

NodePull membrane_pull(const membrane::Law& law, const membrane::Rest& rest, const mesh::Triangle& nodes,
                       const Ways& ways, std::uint32_t first, std::size_t corner, double dt) {
  membrane::Corners places, starts;
  for (std::size_t i = 0; i < 3; ++i) {
    places[i] = ways.place(first + nodes[i]);
    starts[i] = ways.start[first + nodes[i]];
  }
  const membrane::StepStress end = membrane::step_stress(law, membrane::deformation(rest, places),
                                                         membrane::deformation(rest, starts), 1 / dt);
  return {membrane::forces(rest, end.stress)[corner],
          Sym3::symmetric_part(membrane::blocks(rest, end.hessian)[corner][corner])};
}

}  // namespace

FabricDescent::FabricDescent(const Model& model, const Body& body)
    : membranes_of_(
          incidence(model.elements(ElementKind::Membrane, body), body.first_vertex, body.vertex_count)),
      hinges_of_(incidence(model.elements(ElementKind::Hinge, body), body.first_vertex, body.vertex_count)),
      resistance_(hinge::stiffness_bounds(model.plate(body))) {}

/// Equation (6).
void FabricDescent::begin_sweep(const Ways& ways, const FabricCloth& cloth, double dt) {
  begun_.clear();
  std::vector<double> bends;
  for (const hinge::Hinge& hinge : cloth.plate.hinges) {
    begun_.push_back(bend_of(hinge, ways, cloth.first, cloth.membranes.law.delay, dt));
    bends.push_back(begun_.back().angle + begun_.back().delayed);
  }
  moments_ = hinge::moments(cloth.plate, bends, cloth.creases);
}

NodePull FabricDescent::pull(const Ways& ways, const FabricCloth& cloth, std::uint32_t node,
                             double dt) const {
  NodePull sum;
  const membrane::Membranes& membranes = cloth.membranes;
  for (const std::uint32_t at : membranes_of_.row(node)) {
    const mesh::Triangle& nodes = membranes.triangles[at];
    const auto corner = static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), node) - nodes.begin());
    const NodePull own =
        membrane_pull(membranes.law, membranes.rests[at], nodes, ways, cloth.first, corner, dt);
    sum.force += own.force;
    sum.hessian += own.hessian;
  }
  const double delay = membranes.law.delay;
  for (const std::uint32_t at : hinges_of_.row(node)) {
    const hinge::Hinge& hinge = cloth.plate.hinges[at];
    const auto corner = static_cast<std::size_t>(std::find(hinge.nodes.begin(), hinge.nodes.end(), node) -
                                                 hinge.nodes.begin());
    const Bend now = bend_of(hinge, ways, cloth.first, delay, dt);
    const Vec3d slope = hinge::angle_slope(corners_of(hinge, ways, cloth.first))[corner];
    const double by = short_way(now.angle - begun_[at].angle) + now.delayed - begun_[at].delayed;
    sum.force += -(moments_[at] + resistance_[at] * by) * slope;
    sum.hessian += Sym3::outer(slope, (1 + delay / dt) * resistance_[at]);
  }
  return sum;
}

}  // namespace weft::reference
