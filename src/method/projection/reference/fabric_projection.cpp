#include "method/projection/reference/fabric_projection.hpp"

#include <array>

#include "element/membrane/form.hpp"
#include "method/reference_hinges.hpp"
#include "method/sym3.hpp"

namespace weft::reference {
namespace {

using membrane::Axes;
using membrane::Strain;

/// Three constraints of one triangle.
struct Block {
  const mesh::Triangle& nodes;
  const membrane::Rest& rest;
  Strain strain;                    // at the ways so far
  Strain steep;                     // membrane::steep_slopes
  Stiffness stiffness;              // by area [N/m]
  double elastic = 0, damping = 0;  // h² and h τ [s²]
};

std::array<Vec3d, 3> slopes_at(const membrane::Rest& rest, const Strain& strain, std::size_t corner) {
  const MaterialPoint& slope = rest.slope[corner];
  const auto of = [&](const Axes& a) { return slope.warp * a.warp + slope.weft * a.weft; };
  return {of(strain.warp), of(strain.weft), of(strain.shear)};
}

/// (A K)⁻¹ [1/(N·m)].
Sym3 compliance_of(const Stiffness& k, double area) {
  const double scale = 1 / (area * (k.warp * k.weft - k.coupled * k.coupled));
  return {scale * k.weft, -scale * k.coupled, 0, scale * k.warp, 0, 1 / (area * k.shear)};
}

/// Equations (8) and (9).
void project(Ways& ways, const Block& block, std::uint32_t first, Vec3d& multiplier) {
  const Sym3 compliance = compliance_of(block.stiffness, block.rest.area);
  Vec3d rate;  // h times it
  Sym3 weights;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t node = first + block.nodes[i];
    const auto slope = slopes_at(block.rest, block.strain, i);
    rate +=
        Vec3d{dot(slope[0], ways.way[node]), dot(slope[1], ways.way[node]), dot(slope[2], ways.way[node])};
    const auto [a, b, c] = slopes_at(block.rest, block.steep, i);
    weights +=
        ways.inverse_mass[node] * Sym3{dot(a, a), dot(a, b), dot(a, c), dot(b, b), dot(b, c), dot(c, c)};
  }
  const auto& [warp, weft, shear] = block.strain.value;
  const Vec3d left =
      block.elastic * Vec3d{warp, weft, shear} + block.damping * rate + compliance * multiplier;
  const Vec3d change = -1.0 * (inverse(compliance + (block.elastic + block.damping) * weights) * left);
  multiplier += change;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t node = first + block.nodes[i];
    const auto slope = slopes_at(block.rest, block.strain, i);
    ways.way[node] +=
        ways.inverse_mass[node] * (change.x * slope[0] + change.y * slope[1] + change.z * slope[2]);
  }
}

}  // namespace

FabricProjection::FabricProjection(const Model& model, const Body& body, Multipliers multipliers)
    : multipliers_(multipliers),
      membranes_(color_elements(model.elements(ElementKind::Membrane, body), model.vertex_count())),
      hinges_(color_elements(model.elements(ElementKind::Hinge, body), model.vertex_count())),
      resistance_(hinge::stiffness_bounds(model.plate(body))) {
  begin();
}

void FabricProjection::begin() {
  strained_.assign(membranes_.elements.size(), {});
  damped_.assign(membranes_.elements.size(), {});
  bent_.assign(hinges_.elements.size(), 0);
}

/// Equations (10) to (12).
void FabricProjection::project_hinges(Ways& ways, const FabricCloth& cloth,
                                      std::span<const std::uint32_t> order, double dt) {
  const double delay = cloth.membranes.law.delay;
  std::vector<Bend> before;
  std::vector<double> bends;
  for (const hinge::Hinge& hinge : cloth.plate.hinges) {
    before.push_back(bend_of(hinge, ways, cloth.first, delay, dt));
    bends.push_back(before.back().angle + before.back().delayed);
  }
  const std::vector<double> moments = hinge::moments(cloth.plate, bends, cloth.creases);
  for (const std::uint32_t number : order) {
    const hinge::Hinge& hinge = cloth.plate.hinges[number];
    const hinge::Corners slope = hinge::angle_slope(corners_of(hinge, ways, cloth.first));
    double weight = 0;
    for (std::size_t i = 0; i < 4; ++i)
      weight += ways.inverse_mass[cloth.first + hinge.nodes[i]] * dot(slope[i], slope[i]);
    const Bend now = bend_of(hinge, ways, cloth.first, delay, dt);
    const double turned = short_way(now.angle - before[number].angle);
    const double moment =
        moments[number] + resistance_[number] * (turned + now.delayed - before[number].delayed);
    const double change =
        -(dt * dt * moment + bent_[number]) / (1 + (dt * dt + dt * delay) * resistance_[number] * weight);
    bent_[number] += change;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t node = cloth.first + hinge.nodes[i];
      ways.way[node] += ways.inverse_mass[node] * change * slope[i];
    }
  }
}

void FabricProjection::project_membrane(Ways& ways, const FabricCloth& cloth, std::uint32_t triangle,
                                        double dt) {
  const membrane::Membranes& all = cloth.membranes;
  const mesh::Triangle& nodes = all.triangles[triangle];
  const membrane::Rest& rest = all.rests[triangle];
  const auto deformed = [&] {
    membrane::Corners corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = ways.place(cloth.first + nodes[i]);
    return membrane::deformation(rest, corners);
  };
  const bool apart = all.law.energy == membrane::Energy::NeoHookean;  // its damping has strains of its own
  const membrane::Axes f = deformed();
  const membrane::Form form = membrane::form(all.law, f);
  project(ways,
          {nodes, rest, form.strain, membrane::steep_slopes(all.law.energy, f), form.stiffness, dt * dt,
           apart ? 0 : dt * all.law.delay},
          cloth.first, strained_[triangle]);
  if (!apart || all.law.delay == 0) return;
  constexpr membrane::Energy kGreen = membrane::Energy::Green;
  const membrane::Axes then = deformed();
  project(ways,
          {nodes, rest, membrane::strain_of(kGreen, then), membrane::steep_slopes(kGreen, then),
           all.law.stiffness, 0, dt * all.law.delay},
          cloth.first, damped_[triangle]);
}

void FabricProjection::sweep(Ways& ways, const FabricCloth& cloth, double dt) {
  const std::vector<std::uint32_t>&triangles = membranes_.elements, &hinges = hinges_.elements;
  const std::vector<std::uint32_t> back(hinges.rbegin(), hinges.rend());
  if (multipliers_ == Multipliers::Forgotten) begin();
  project_hinges(ways, cloth, hinges, dt);
  for (const std::uint32_t triangle : triangles) project_membrane(ways, cloth, triangle, dt);
  if (multipliers_ == Multipliers::Forgotten) begin();
  for (auto triangle = triangles.rbegin(); triangle != triangles.rend(); ++triangle)
    project_membrane(ways, cloth, *triangle, dt);
  project_hinges(ways, cloth, back, dt);
}

}  // namespace weft::reference
