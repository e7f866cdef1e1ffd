#include "method/multigrid/bottom.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "element/spring/law.hpp"
#include "method/multigrid/grid_levels.hpp"
#include "model/cloth_size.hpp"
#include "model/cords.hpp"
#include "model/fabric.hpp"
#include "model/solid.hpp"

namespace weft::multigrid {
namespace {

constexpr std::uint32_t kInvocations = 256;  // of the workgroup
constexpr std::uint32_t kStages = 6;         // of a level above the bottom

/// Of an edge beyond its strain limit, by that within: docs/solvers/multigrid.md, equation 5a.
constexpr double kBeyondLimit = 1 + spring::kStiffer;

/// D⁻¹ A has the least eigenvalue where the cloth moves as a whole, but for a margin; or where neighbours move against
/// each other, out of the sheet, which stiffness does not see: Pᵀ M P of bilinear functions has a quarter of its
/// diagonal there.
constexpr double kMargin = 0.8, kOutOfPlane = 0.25;

/// h_e of (1), with a history.
double formula_length(double step) { return 2 * step / 3; }

/// Sweeps that make each part of an error smaller by kBottomPart, for eigenvalues that differ by `condition`.
std::uint32_t sweeps_for(double condition) {
  const double each = std::acosh((condition + 1) / (condition - 1));
  return static_cast<std::uint32_t>(std::ceil(std::acosh(kBottomPart) / each));
}

std::uint32_t rounds(const LevelScale& level) { return (level.nodes + kInvocations - 1) / kInvocations; }

std::vector<LevelScale> fabric_scales(const Model& model, const Body& body, std::span<const MeshLevel> levels,
                                      double step) {
  const double he = formula_length(step), area = area_of(model, body);
  const double inertia = mass_of(model, body) / (he * he), damped = 1 + body.fabric->damping / he;
  const Stiffness membrane = membrane_law(*body.fabric).stiffness, bending = bending_law(*body.fabric);
  double limits = 0;  // those of springs, as below
  for (const Cord& limit : limit_cords(model, body)) {
    const Vec3d span =
        model.rest_position[body.first_vertex + limit.b] - model.rest_position[body.first_vertex + limit.a];
    limits += limit.stiffness * dot(span, span);
  }
  const double stretching =
      4.0 / 3 * (damped * (membrane.warp + membrane.weft + 2 * membrane.shear) + limits / area);
  // Coarse functions bend in lines of the finest hinges, whose stiffness is bounded by some five times a sheet's.
  const double fine = std::sqrt(area / levels[0].node_count);
  const double most = 30 * damped * (bending.warp + bending.weft + 2 * bending.shear);
  std::vector<LevelScale> scales;
  for (const MeshLevel& level : levels) {
    const double bends = most / (fine * std::sqrt(area / level.node_count));
    // The smoothed matrix is the inverse of a part of the diagonal's inverse.
    scales.push_back({level.node_count, inertia / level.node_count,
                      (stretching + bends) + (1 / kElementDiagonalPart - 1) *
                                                 (inertia / level.node_count + stretching + bends)});
  }
  return scales;
}

/// A node's stiffness goes with the distance of nodes, and its mass with that cubed. Linear functions on cells of side
/// s have 6 s of |∇φ|², in each direction 2 s.
LevelScale solid_scale(const Model& model, const Body& body, double volume, double nodes, double step) {
  const double he = formula_length(step), own = mass_of(model, body) / (he * he) / nodes;
  const tet::Law law = tet_law(*body.solid);
  const double modulus = (1 + law.delay / he) * (6 * law.mu + 2 * (law.lambda + law.mu));
  const double stiffness = modulus * std::cbrt(volume / nodes);
  return {0, own, stiffness + (1 / kElementDiagonalPart - 1) * (own + stiffness)};
}

/// Of several bodies that which has least inertia for its stiffness; each has its part of a level's nodes.
std::vector<LevelScale> solid_scales(const Model& model, const SystemBodies& bodies,
                                     std::span<const MeshLevel> levels, double step) {
  std::vector<double> volumes;
  for (const Body& body : bodies.bodies) volumes.push_back(volume_of(model, body));
  std::vector<LevelScale> scales;
  for (const MeshLevel& level : levels) {
    LevelScale stiffest;
    for (std::size_t b = 0; b < bodies.bodies.size(); ++b) {
      const Body& body = bodies.bodies[b];
      const double nodes =
          std::max(1.0, static_cast<double>(level.node_count) * body.vertex_count / bodies.vertex_count());
      const LevelScale one = solid_scale(model, body, volumes[b], nodes, step);
      if (stiffest.nodes == 0 || one.inertia * stiffest.stiffness < stiffest.inertia * one.stiffness)
        stiffest = one;
      stiffest.nodes = level.node_count;
    }
    scales.push_back(stiffest);
  }
  return scales;
}

}  // namespace

std::vector<LevelScale> grid_scales(const Model& model, const Body& body, double step) {
  const mesh::Grid& grid = *body.grid;
  const double he = formula_length(step), inertia = mass_of(model, body) / (he * he);
  const auto [curve_i, curve_j] = bending_stiffness(body);
  const scene::Stiffness& k = body.stiffness;
  const double structural = k.structural * (body.strain_limit ? kBeyondLimit : 1);
  // The sheet's resistance along either side [N/m]: a spring counts by the square of its length, diagonals half of it.
  const double along = structural + 2 * k.shear + 4 * k.bend + (1 + 2 + 4) * body.damping / he;
  const double cell = (grid.width / (grid.nx - 1)) / (grid.height / (grid.ny - 1));
  std::vector<LevelScale> scales;
  for (const GridLevel& level : grid_levels(grid.nx, grid.ny)) {
    const std::uint32_t nodes = level.nx * level.ny;
    const double longer = static_cast<double>(level.interval_i) / level.interval_j;
    // A bilinear φ's ∫ |∂φ/∂i|² over its four cells is 4/3 times their side along j over that along i.
    const double springs = 4.0 / 3 * along * (cell * longer + 1 / (cell * longer));
    const double bending = 6 * (curve_i * level.bending_i + curve_j * level.bending_j);
    scales.push_back({nodes, inertia / nodes, springs + bending});
  }
  return scales;
}

std::vector<LevelScale> mesh_scales(const Model& model, const SystemBodies& bodies,
                                    std::span<const MeshLevel> levels, double step) {
  const Body& body = bodies.first();
  if (body.fabric) return fabric_scales(model, body, levels, step);
  if (body.solid) return solid_scales(model, bodies, levels, step);
  const double he = formula_length(step), inertia = mass_of(model, body) / (he * he);
  double springs = 0;
  for (const Spring s : model.springs(body)) {
    const double k = s.stiffness * (body.strain_limit ? kBeyondLimit : 1), l0 = s.rest_length;
    springs += (k + s.damping / he) * l0 * l0;
  }
  const double stiffness = 4.0 / 3 * springs / area_of(model, body);
  std::vector<LevelScale> scales;
  for (const MeshLevel& level : levels)
    scales.push_back({level.node_count, inertia / level.node_count, stiffness});
  return scales;
}

std::vector<float> norm_scales(const Model& model, const SystemBodies& bodies, double step) {
  std::vector<double> norms;  // of what pulls all nodes alike, squared: Σ r·D⁻¹r, r in proportion to the mass
  for (const Body& body : bodies.bodies) {
    const LevelScale node = solid_scale(model, body, volume_of(model, body), body.vertex_count, step);
    norms.push_back(body.vertex_count * node.inertia * node.inertia / (node.inertia + node.stiffness));
  }
  const double most = *std::max_element(norms.begin(), norms.end());
  std::vector<float> scales;
  for (std::size_t b = 0; b < norms.size(); ++b)
    scales.insert(scales.end(), bodies.bodies[b].vertex_count, static_cast<float>(most / norms[b]));
  return scales;
}

Bottom bottom_of(std::span<const LevelScale> levels, std::uint32_t most) {
  std::size_t l = 1;
  while (l + 1 < levels.size() && levels[l].nodes > most) ++l;
  Bottom best{levels.size() - 1};
  std::uint32_t above = 0, least = std::numeric_limits<std::uint32_t>::max();
  for (; l < levels.size(); ++l) {
    const LevelScale& level = levels[l];
    const double low = std::min(kMargin * level.inertia / (level.inertia + level.stiffness), kOutOfPlane);
    const bool known = low >= kBottomLow;
    const Bottom here = known ? Bottom{l, sweeps_for(kSmoothHigh / low), low} : Bottom{l};
    const std::uint32_t work = above + here.sweeps * rounds(level);
    if ((known || l + 1 == levels.size()) && work < least) {
      least = work;
      best = here;
    }
    above += kStages * rounds(level);
  }
  return best;
}

}  // namespace weft::multigrid
