#include "method/multigrid/reference/fabric_terms.hpp"

#include "method/multigrid/lead.hpp"
#include "method/multigrid/reference/element_blocks.hpp"
#include "method/multigrid/reference/spring_terms.hpp"

namespace weft::reference {
namespace {

using membrane::Axes, membrane::Hessian;

Axes operator*(double s, const Axes& f) { return {s * f.warp, s * f.weft}; }
Axes operator+(const Axes& a, const Axes& b) { return {a.warp + b.warp, a.weft + b.weft}; }

/// Of one membrane: its force where its corners have come to place + start, and its part of the matrix.
membrane::Blocks add_membrane(MeshStep& step, const membrane::Membranes& all, std::size_t number,
                              double rate) {
  const membrane::Law& law = all.law;
  const Axes f = all.deformation(number, step.place), way = all.deformation(number, step.start);
  const double lead = step.leads ? multigrid::lead_of(dot(way.warp, way.warp) + dot(way.weft, way.weft)) : 0;
  const Axes at = f + lead * way;
  const Hessian elastic = membrane::positive_hessian(law, at);
  const Axes damping =
      membrane::damping_stress(law, step.leads ? at : f + way, all.deformation(number, step.start_velocity));
  const Axes stress = membrane::stress(law, at) + elastic * ((1 - lead) * way) + damping;
  const membrane::Corners forces = membrane::forces(all.rests[number], stress);
  for (std::size_t i = 0; i < 3; ++i) step.residual[all.triangles[number][i]] += forces[i];
  const Hessian held = step.leads ? elastic : membrane::held_hessian(law, at, way);
  return membrane::blocks(all.rests[number], held + rate * membrane::damping_hessian(law, at));
}

/// Of a cord: its force, and its part of the matrix at each of its ends.
Mat3 add_cord(MeshStep& step, const Cord& cord, double rate) {
  const SpringTerms terms = spring_terms(law_of(cord), cord.damping, step, cord.a, cord.b, rate);
  step.residual[cord.a] += terms.force;
  step.residual[cord.b] -= terms.force;
  return Mat3::outer((terms.stiffness * (1 - terms.stretch) + terms.damping) * terms.direction,
                     terms.direction) +
         Mat3::identity(terms.stiffness * terms.stretch);
}

}  // namespace

void add_fabric(MeshStep& step, const FabricCloth& cloth, std::span<const Cord> cords,
                const ElementPairs& parts, std::span<const double> bounds, double rate) {
  Field there = step.place;
  for (std::size_t a = 0; a < there.size(); ++a) there[a] += step.start[a];
  std::vector<membrane::Blocks> membranes;
  for (std::size_t t = 0; t < cloth.membranes.triangles.size(); ++t)
    membranes.push_back(add_membrane(step, cloth.membranes, t, rate));

  const double delay = cloth.membranes.law.delay;
  std::vector<double> bends = hinge::bends(cloth.plate, there);
  const std::vector<double> rates = hinge::bend_rates(cloth.plate, there, step.start_velocity);
  for (std::size_t h = 0; h < bends.size(); ++h) bends[h] += delay * rates[h];
  hinge::add_forces(cloth.plate, hinge::moments(cloth.plate, bends, cloth.creases), there, step.residual);
  std::vector<hinge::Corners> slopes;
  for (const hinge::Hinge& hinge : cloth.plate.hinges)
    slopes.push_back(hinge::angle_slope(hinge::corners_of(hinge, there)));

  std::vector<Mat3> blocks_of_cords;
  for (const Cord& cord : cords) blocks_of_cords.push_back(add_cord(step, cord, rate));

  const auto block_of = [&](const ElementPart& part) -> Mat3 {
    switch (part.kind) {
      case PartKind::Membrane:
        return membranes[part.element][part.row][part.column];
      case PartKind::Hinge:
        return (1 + delay * rate) * bounds[part.element] *
               Mat3::outer(slopes[part.element][part.row], slopes[part.element][part.column]);
      case PartKind::Cord:
        return (part.row == part.column ? 1.0 : -1.0) * blocks_of_cords[part.element];
      case PartKind::Tet:
        break;  // fabric has none
    }
    return {};
  };
  add_blocks(step, parts, block_of);
}

}  // namespace weft::reference
