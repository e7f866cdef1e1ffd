#include "method/multigrid/reference/solid_terms.hpp"

#include "element/tet/hessian.hpp"
#include "method/multigrid/lead.hpp"
#include "method/multigrid/reference/element_blocks.hpp"

namespace weft::reference {
namespace {

struct Term {
  tet::Frame frame;
  tet::Hessian hessian;
  const tet::Rest* rest;
};

/// Of one tetrahedron of a body, whose first node is `first`: its force where its corners have come to place + start,
/// and how that grows.
Term add_tet(MeshStep& step, const tet::Tets& all, std::size_t first, std::size_t number, double rate) {
  const tet::Law& law = all.law;
  const auto change = [&](const Field& field) {
    return all.deformation(number, std::span(field).subspan(first));
  };
  const Mat3 f = change(step.place), way = change(step.start);
  const double lead = step.leads ? multigrid::lead_of(contraction(way, way)) : 0;
  const Mat3 at = f + lead * way;
  const tet::Frame frame = tet::frame_of(at);
  const tet::Hessian elastic = tet::positive_hessian(law, frame);
  Mat3 stress = tet::stress(law, at) + tet::times(frame, elastic, (1 - lead) * way);
  if (law.delay > 0)
    stress += tet::damping_stress(law, step.leads ? at : f + way, change(step.start_velocity));
  const tet::Corners forces = tet::forces(all.rests[number], stress);
  for (std::size_t k = 0; k < 4; ++k) step.residual[first + all.tets[number][k]] += forces[k];
  const tet::Hessian held = step.leads ? elastic : tet::held_hessian(law, frame, way);
  return {frame, held + rate * tet::damping_hessian(law, frame), &all.rests[number]};
}

}  // namespace

void add_solids(MeshStep& step, std::span<const SolidBody> bodies, std::size_t first,
                const ElementPairs& parts, double rate) {
  std::vector<Term> terms;
  for (const SolidBody& body : bodies)
    for (std::size_t t = 0; t < body.tets.tets.size(); ++t)
      terms.push_back(add_tet(step, body.tets, body.first - first, t, rate));
  add_blocks(step, parts, [&](const ElementPart& part) {
    const auto& [frame, hessian, rest] = terms[part.element];
    return tet::block(frame, hessian, *rest, part.row, part.column);
  });
}

}  // namespace weft::reference
