#include "method/vbd/reference/solid_descent.hpp"

#include <algorithm>

#include "element/incidence.hpp"

namespace weft::reference {

SolidDescent::SolidDescent(const Model& model, const Body& body)
    : tets_of_(incidence(model.elements(ElementKind::Tet, body), body.first_vertex, body.vertex_count)) {}

NodePull SolidDescent::pull(const Ways& ways, const SolidBody& solid, std::uint32_t node, double dt) const {
  NodePull sum;
  const tet::Tets& all = solid.tets;
  for (const std::uint32_t at : tets_of_.row(node)) {
    const mesh::Tet& nodes = all.tets[at];
    const auto corner = static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), node) - nodes.begin());
    tet::Corners places, starts;
    for (std::size_t k = 0; k < 4; ++k) {
      places[k] = ways.place(solid.first + nodes[k]);
      starts[k] = ways.start[solid.first + nodes[k]];
    }
    const tet::CornerPull own =
        tet::corner_pull(all.law, all.rests[at], tet::deformation(all.rests[at], places),
                         tet::deformation(all.rests[at], starts), 1 / dt, corner);
    sum.force += own.force;
    sum.hessian += Sym3::symmetric_part(own.hessian);
  }
  return sum;
}

}  // namespace weft::reference
