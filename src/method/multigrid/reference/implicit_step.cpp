#include "method/multigrid/reference/implicit_step.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "method/air_reference.hpp"
#include "method/multigrid/reference/fabric_terms.hpp"
#include "method/multigrid/reference/solid_terms.hpp"
#include "method/multigrid/reference/spring_terms.hpp"
#include "method/pieces/reference/piece_turn.hpp"

namespace weft::reference {
namespace {

struct Link {
  std::uint32_t a = 0, b = 0;  // of the cloth
  int di = 0, dj = 0;
  SpringLink spring;
};

Link link_of(const SpringLink& spring, std::uint32_t first, std::uint32_t nx) {
  Link link{spring.node_a - first, spring.node_b - first, 0, 0, spring};
  link.di = static_cast<int>(link.b % nx) - static_cast<int>(link.a % nx);
  link.dj = static_cast<int>(link.b / nx) - static_cast<int>(link.a / nx);
  return link;
}

bool is_far(const Link& link) { return std::abs(link.di) > 1 || link.dj > 1; }

/// Adds springs of a mesh, one a pair of nodes, to its residual and matrix.
void add_springs(MeshStep& step, std::span<const SpringLink> springs, std::uint32_t first, double rate) {
  std::vector<Sym3>& blocks = step.matrix.blocks;
  std::size_t block = step.fixed.size();
  for (const SpringLink& s : springs) {
    const std::size_t a = s.node_a - first, b = s.node_b - first;
    const SpringTerms terms = spring_terms(s.law(), s.damping, step, a, b, rate);
    step.residual[a] += terms.force;
    step.residual[b] -= terms.force;
    if (!step.fixed[a]) blocks[a] += terms.block();
    if (!step.fixed[b]) blocks[b] += terms.block();
    if (!step.fixed[a] && !step.fixed[b]) blocks[block] = -1.0 * terms.block();
    ++block;
  }
}

std::size_t place_of(const Link& link) { return link.dj == 0 ? 1 : link.di < 0 ? 4 : link.di == 0 ? 2 : 3; }

void add_near(GridOperator& matrix, const Link& link, const Sym3& block) {
  matrix.rows[link.a][0] += block;
  matrix.rows[link.b][0] += block;
  if (!matrix.fixed[link.a] && !matrix.fixed[link.b]) matrix.rows[link.a][place_of(link)] += -1.0 * block;
}

/// Adds the differences that name a fixed node: no coarse level has those, since it knows of no fixed node. Where the
/// middle one is fixed, |a + b|² <= 2 |a|² + 2 |b|² takes the others apart.
void add_held_bending(GridOperator& source) {
  for (const bool along_i : {true, false}) {
    const std::uint32_t stride = along_i ? 1 : source.nx;
    for_each_bend(source, along_i, [&](std::uint32_t m, double stiffness, double) {
      const std::uint32_t before = m - stride, behind = m + stride;
      if (!source.fixed[before] && !source.fixed[m] && !source.fixed[behind]) return;
      const bool apart = source.fixed[m] && !source.fixed[before] && !source.fixed[behind];
      const double ends = apart ? 2 * stiffness : stiffness;
      source.rows[before][0] += Sym3::identity(ends);
      source.rows[m][0] += Sym3::identity(4 * stiffness);
      source.rows[behind][0] += Sym3::identity(ends);
      const std::size_t next = along_i ? 1 : 2;
      if (!source.fixed[before] && !source.fixed[m])
        source.rows[before][next] += Sym3::identity(-2 * stiffness);
      if (!source.fixed[m] && !source.fixed[behind]) source.rows[m][next] += Sym3::identity(-2 * stiffness);
    });
  }
}

/// Where obstacles press nodes of a cloth: add(node, block) puts what holds one into the matrix, and the residual gets
/// its force. `behind`: of a body, the diagonal of the matrix.
template <class Add>
void hold_at_obstacles(StepStart& step, std::span<const Press> presses, std::span<const HoldForce> kept,
                       std::span<const Sym3> behind, const MassSpringSystem& system, std::size_t first,
                       double dt, bool again, const Add& add) {
  for (std::size_t a = 0; a < presses.size(); ++a) {
    if (step.fixed[a]) continue;
    step.holds[a] = Hold::of(presses[a], kept[a],
                             {step.inertia[a], behind.empty() ? std::nullopt : std::optional(behind[a]),
                              1 / system.inverse_mass[first + a], dt, again ? Vec3d{} : step.residual[a],
                              step.way[a] + step.start[a], dt * system.velocity[first + a]});
    if (!step.holds[a]) continue;
    step.residual[a] += step.holds[a]->force();
    add(a, step.holds[a]->block());
  }
}

/// Of what pulls all nodes alike: the norm in which a system's residual is measured. `way`: that in a substep [m].
double weight_norm(const StepStart& step, const std::vector<Sym3>& inverse, std::span<const float> scales,
                   const Vec3d& way) {
  double square = 0;
  for (std::size_t a = 0; a < inverse.size(); ++a) {
    const Vec3d pull = step.inertia[a] * way;
    if (!step.fixed[a]) square += (scales.empty() ? 1 : scales[a]) * dot(pull, inverse[a] * pull);
  }
  return std::sqrt(square);
}

}  // namespace

StepFormula step_formula(double dt, double ratio) {
  return {dt * (1 + ratio) / (1 + 2 * ratio), ratio * ratio / (1 + 2 * ratio)};
}

ImplicitStepper::ImplicitStepper(const Model& model, double step, double residual, std::uint32_t newton_steps)
    : wanted_residual(residual),
      newton_steps_(newton_steps),
      joined_(free_pieces(model, PiecesOf::Solids)),
      pieces_(free_pieces(model, PiecesOf::Bodies)),
      position_before_(model.vertex_count()),
      velocity_before_(model.vertex_count()) {
  std::size_t springs = 0, fabrics = 0, solids = 0;
  std::map<multigrid::CycleKind, multigrid::Smoothing> finest;
  for (const multigrid::SystemBodies& bodies : multigrid::systems_of(model)) {
    const Body& body = bodies.first();
    Cloth made{bodies.first_vertex(), bodies.vertex_count()};
    const multigrid::CycleKind kind = multigrid::kind_of(body);
    if (!finest.contains(kind)) finest[kind] = multigrid::finest_smoothing(model, kind, step);
    made.finest = finest[kind];
    if (body.fabric || body.solid) {
      if (body.fabric) {
        made.fabric = fabrics++;
        made.cords = cords_of(model, body);
        springs += model.count(ElementKind::Spring, body);
        made.hinge_bounds = hinge::stiffness_bounds(model.plate(body));
      } else {
        made.first_solid = solids;
        made.solids = bodies.bodies.size();
        solids += made.solids;
      }
      if (body.solid) made.norm_scales = multigrid::norm_scales(model, bodies, step);
      made.parts = element_pairs(model, bodies);
      made.levels = mesh_levels(model, bodies, made.parts.pairs, Blocks::General);
      made.bottom = multigrid::bottom_of(multigrid::mesh_scales(model, bodies, made.levels, step),
                                         multigrid::kMeshTail);
    } else if (body.grid) {
      made.nx = body.grid->nx;
      made.ny = body.grid->ny;
      const auto [along_i, along_j] = bending_stiffness(body);
      made.bending = {along_i, along_j, 1, 1, body.weights == mesh::BoundaryWeights::Uniform};
      made.bottom = multigrid::bottom_of(multigrid::grid_scales(model, body, step), multigrid::kGridTail);
      springs += mesh::grid_spring_count(*body.grid);
    } else {
      const Springs own = model.springs(body);
      made.levels = mesh_levels(model, body, own);
      made.bottom = multigrid::bottom_of(multigrid::mesh_scales(model, bodies, made.levels, step),
                                         multigrid::kMeshTail);
      made.first_spring = springs;
      springs += own.size();
    }
    cloths_.push_back(std::move(made));
  }
  forget();
}

void ImplicitStepper::remember(std::vector<Vec3d> position, std::vector<Vec3d> velocity) {
  position_before_ = std::move(position);
  velocity_before_ = std::move(velocity);
  known_.assign(position_before_.size(), true);
}

void ImplicitStepper::forget() {
  known_.assign(position_before_.size(), false);
  hold_forces_.assign(position_before_.size(), {});
}

StepStart ImplicitStepper::begin(const MassSpringSystem& system, const std::vector<Vec3d>& places, double dt,
                                 double ratio, const Cloth& cloth, std::span<const Vec3d> ways) const {
  StepStart step;
  step.way.resize(cloth.count);
  step.place.resize(cloth.count);
  step.start.resize(cloth.count);
  step.start_velocity.resize(cloth.count);
  step.residual.resize(cloth.count);
  step.guess.resize(cloth.count);
  step.inertia.resize(cloth.count);
  step.fixed.assign(cloth.count, false);
  step.holds.resize(cloth.count);
  for (std::size_t a = 0; a < cloth.count; ++a) {
    const std::size_t node = cloth.first + a;
    const Vec3d x = system.position[node], v = system.velocity[node];
    step.place[a] = x;
    if (system.inverse_mass[node] == 0) {
      step.place[a] = places[node];
    } else if (const auto velocity = grab_velocity(system, node)) {
      step.place[a] = x + dt * *velocity;
    } else {
      const StepFormula formula = step_formula(dt, known_[node] ? ratio : 0);
      const double he = formula.he, mass = 1 / system.inverse_mass[node];
      const Vec3d s = known_[node] ? formula.c * (x - position_before_[node]) : Vec3d{};
      const Vec3d base_velocity = known_[node] ? v + formula.c * (v - velocity_before_[node]) : v;
      const Vec3d pull = system.acceleration + system.drag * wind_at(system.wind, x, system.time);
      if (ways.empty()) {
        step.start[a] = dt * v;
        if (known_[node]) step.guess[a] = s + he * (v + ratio * (v - velocity_before_[node])) - step.start[a];
      } else {
        step.way[a] = ways[node];
        step.place[a] = x + ways[node];
      }
      step.start_velocity[a] = (step.way[a] + step.start[a] - s) / he;
      step.residual[a] = mass * ((base_velocity - step.start_velocity[a]) / he + pull -
                                 system.drag * step.start_velocity[a]);
      step.inertia[a] = mass * (1 / (he * he) + system.drag / he);
      continue;
    }
    step.fixed[a] = true;
    step.way[a] = step.place[a] - x;
    step.start_velocity[a] = (step.place[a] - x) / dt;
  }
  add_gas(step, system, dt, cloth);
  if (system.air) add_air(step, system, dt, ratio, cloth, !ways.empty());
  return step;
}

void ImplicitStepper::add_gas(StepStart& step, const MassSpringSystem& system, double dt,
                              const Cloth& cloth) {
  if (system.gases.empty()) return;
  Field ahead = system.position;
  for (std::size_t node = 0; node < ahead.size(); ++node) ahead[node] += dt * system.velocity[node];
  const Field forces = gas_forces(system, ahead);
  for (std::size_t a = 0; a < cloth.count; ++a)
    if (!step.fixed[a]) step.residual[a] += forces[cloth.first + a];
}

void ImplicitStepper::add_air(StepStart& step, const MassSpringSystem& system, double dt, double ratio,
                              const Cloth& cloth, bool again) const {
  std::vector<AirTriangle> triangles;
  for (AirTriangle triangle : system.triangles) {
    if (triangle.corners[0] < cloth.first || triangle.corners[0] >= cloth.first + cloth.count) continue;
    for (std::uint32_t& node : triangle.corners) node -= cloth.first;
    triangles.push_back(triangle);
  }
  Field place(cloth.count), wind(cloth.count), slip(cloth.count);
  for (std::size_t a = 0; a < cloth.count; ++a) {
    place[a] = step.place[a] + step.start[a];
    wind[a] = wind_at(system.wind, place[a], system.time);
    slip[a] = wind[a] - (again ? step.start_velocity[a] : system.velocity[cloth.first + a]);
  }
  if (!again) {
    const std::vector<double> most = most_air_on_nodes(*system.air, triangles, place, slip);
    for (std::size_t a = 0; a < cloth.count; ++a) {
      const std::size_t node = cloth.first + a;
      if (!known_[node]) continue;
      const double swing = dt * system.inverse_mass[node] * most[a];
      slip[a] -= ratio / std::max(1.0, swing) * (system.velocity[node] - velocity_before_[node]);
    }
  }
  step.air = air_on_nodes(*system.air, triangles, place, slip);
  for (std::size_t a = 0; a < cloth.count; ++a) {
    const double he = step_formula(dt, known_[cloth.first + a] ? ratio : 0).he;
    step.residual[a] += step.air[a] * (wind[a] - step.start_velocity[a]);
    step.air[a] = 1 / he * step.air[a];
  }
}

MeshStep ImplicitStepper::linearise_mesh(const MassSpringSystem& system, const std::vector<Vec3d>& places,
                                         double dt, double ratio, std::size_t c,
                                         std::span<const Press> presses, std::span<const Vec3d> ways) const {
  const Cloth& cloth = cloths_[c];
  MeshStep step{begin(system, places, dt, ratio, cloth, ways), {cloth.levels, {}}};
  step.leads = presses.empty() && newton_steps_ == 0;
  std::vector<Sym3>& blocks = step.matrix.blocks;
  blocks.resize(cloth.levels[0].block_count);
  for (std::size_t a = 0; a < cloth.count; ++a) blocks[a] = Sym3::identity(step.inertia[a]);
  const double rate = 1 / step_formula(dt, ratio).he;
  if (cloth.fabric)
    add_fabric(step, system.fabrics[*cloth.fabric], cloth.cords, cloth.parts, cloth.hinge_bounds, rate);
  else if (cloth.solids > 0)
    add_solids(step, std::span(system.solids).subspan(cloth.first_solid, cloth.solids), cloth.first,
               cloth.parts, rate);
  else
    add_springs(step, std::span(system.springs).subspan(cloth.first_spring, blocks.size() - cloth.count),
                cloth.first, rate);
  for (std::size_t a = 0; a < cloth.count; ++a)
    if (step.fixed[a]) step.residual[a] = {};
  for (std::size_t a = 0; a < step.air.size(); ++a)
    if (!step.fixed[a]) blocks[a] += step.air[a];
  if (!presses.empty())
    hold_at_obstacles(
        step, presses.subspan(cloth.first, cloth.count), std::span(hold_forces_).subspan(cloth.first),
        cloth.solids > 0 ? std::span<const Sym3>(blocks) : std::span<const Sym3>{}, system, cloth.first, dt,
        !ways.empty(), [&](std::size_t a, const Sym3& hold) { blocks[a] += hold; });
  return step;
}

LinearStep ImplicitStepper::linearise(const MassSpringSystem& system, const std::vector<Vec3d>& places,
                                      double dt, double ratio, std::size_t c, std::span<const Press> presses,
                                      std::span<const Vec3d> ways) const {
  const Cloth& cloth = cloths_[c];
  const std::size_t count = cloth.count;
  LinearStep step{begin(system, places, dt, ratio, cloth, ways), {}, {}};
  step.leads = presses.empty() && newton_steps_ == 0;
  step.matrix.nx = cloth.nx;
  step.matrix.ny = cloth.ny;
  step.matrix.rows.resize(count);
  for (std::size_t a = 0; a < count; ++a) step.matrix.rows[a][0] = Sym3::identity(step.inertia[a]);
  for (std::size_t a = 0; a < step.air.size(); ++a) step.matrix.rows[a][0] += step.air[a];
  step.matrix.fixed = step.fixed;
  step.matrix.bending = cloth.bending;
  step.source = step.matrix;
  std::vector<Link> links;
  for (const SpringLink& spring : system.springs)
    if (spring.node_a >= cloth.first && spring.node_a < cloth.first + count)
      links.push_back(link_of(spring, cloth.first, cloth.nx));
  // A bend spring adds to a structural one below it twice its own stiffness: exact where both that it spans
  // have the same stretch.
  std::vector<std::array<double, 2>> below_i(count), below_j(count);  // stiffness, damping
  for (const Link& link : links)
    if (is_far(link)) {
      auto& below = link.dj == 0 ? below_i : below_j;
      for (const std::uint32_t node : {link.a, (link.a + link.b) / 2}) {
        below[node][0] += 2 * link.spring.stiffness;
        below[node][1] += 2 * link.spring.damping;
      }
    }
  const double rate = 1 / step_formula(dt, ratio).he;
  for (const Link& link : links) {
    const SpringLink& s = link.spring;
    const SpringTerms terms = spring_terms(s.law(), s.damping, step, link.a, link.b, rate);
    step.residual[link.a] += terms.force;
    step.residual[link.b] -= terms.force;
    const Sym3 block = terms.block();
    if (is_far(link)) {
      step.matrix.far.push_back({link.a, link.b, block});
      continue;
    }
    add_near(step.matrix, link, block);
    double more = 0, more_damping = 0;
    if (link.di == 0 || link.dj == 0) {
      more = (link.dj == 0 ? below_i : below_j)[link.a][0];
      more_damping = (link.dj == 0 ? below_i : below_j)[link.a][1];
    }
    add_near(step.source, link, block + terms.as_stiff(more, more_damping * rate));
  }
  add_held_bending(step.source);
  GridOperator bending = step.matrix;  // its force is linear: that at place + start
  bending.rows.assign(count, {});
  bending.far.clear();
  Field moved = step.place;
  for (std::size_t a = 0; a < count; ++a) moved[a] += step.start[a];
  const Field curve = bending.apply(moved);
  for (std::size_t a = 0; a < count; ++a)
    step.residual[a] = step.matrix.fixed[a] ? Vec3d{} : step.residual[a] - curve[a];
  if (!presses.empty())
    hold_at_obstacles(step, presses.subspan(cloth.first, count), std::span(hold_forces_).subspan(cloth.first),
                      {}, system, cloth.first, dt, !ways.empty(), [&](std::size_t a, const Sym3& hold) {
                        step.matrix.rows[a][0] += hold;
                        step.source.rows[a][0] += hold;
                      });
  return step;
}

std::vector<PairHold> ImplicitStepper::held_apart(const StepStart& step, const MassSpringSystem& system,
                                                  std::span<const NearPair> pairs, double dt,
                                                  const Cloth& cloth, const std::vector<Sym3>& inverse,
                                                  bool again) const {
  std::vector<double> shares(cloth.count, 0);
  std::vector<std::size_t> own;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const NearPair& pair = pairs[p];
    const auto nodes = std::span(pair.nodes).first(pair.node_count);
    if (!std::all_of(nodes.begin(), nodes.end(), [&](std::uint32_t node) {
          return node >= cloth.first && node < cloth.first + cloth.count;
        }))
      continue;
    own.push_back(p);
    for (std::uint32_t k = 0; k < pair.node_count; ++k)
      shares[pair.nodes[k] - cloth.first] += std::abs(pair.weights[k]);
  }
  std::vector<PairHold> holds;
  for (const std::size_t p : own) {
    PairHold::Sides sides{p, cloth.first};
    std::array<double, 2> compliance{}, local{};  // of each side
    for (std::uint32_t k = 0; k < pairs[p].node_count; ++k) {
      const std::uint32_t node = pairs[p].nodes[k], a = node - cloth.first;
      const double share = step.fixed[a] ? 0 : shares[a] * std::abs(pairs[p].weights[k]);
      sides.start += pairs[p].weights[k] * (step.way[a] + step.start[a]);
      sides.ahead += pairs[p].weights[k] * (step.fixed[a] ? step.way[a] : dt * system.velocity[node]);
      if (step.fixed[a]) continue;
      sides.pull += (pairs[p].weights[k] / step.inertia[a]) * step.residual[a];
      const std::size_t side = pairs[p].weights[k] > 0 ? 0 : 1;
      const double by_mass = share / step.inertia[a],
                   by_matrix = share * dot(pairs[p].direction, inverse[a] * pairs[p].direction);
      sides.compliance += by_mass;
      sides.mobility += share * system.inverse_mass[node];
      if (again) sides.local += by_matrix;
      compliance[side] += by_mass;
      local[side] += by_matrix;
    }
    if (cloth.solids > 0) {
      const auto stiffness_of = [&](std::size_t side) {
        return compliance[side] > 0 ? 1 / std::sqrt(compliance[side] * local[side]) : 0;
      };
      sides.of_bodies = stiffness_of_bodies(stiffness_of(0), stiffness_of(1));
    }
    if (const auto hold = PairHold::of(pairs[p], sides, dt)) holds.push_back(*hold);
  }
  return holds;
}

template <class Enough>
ImplicitStepper::Solved ImplicitStepper::solved(const Substep& substep, const Pressed& pressed, std::size_t c,
                                                std::span<const Vec3d> ways, std::uint32_t most_iterations,
                                                const Enough& enough) const {
  const auto solved = [&](StepStart& step, const auto& hierarchy) -> Solved {
    step.pairs = held_apart(step, substep.system, pressed.pairs, substep.dt, cloths_[c],
                            hierarchy.inverse_diagonals()[0], !ways.empty());
    for (const PairHold& hold : step.pairs) hold.add_force(step.residual, step.fixed);
    const double weight = pressed.presses.empty() || ways.empty()
                              ? 0
                              : weight_norm(step, hierarchy.inverse_diagonals()[0], cloths_[c].norm_scales,
                                            substep.dt * substep.dt * substep.system.acceleration);
    Solution solution =
        solve(hierarchy, step.residual, step.guess, most_iterations,
              {step.pairs, &step.fixed, cloths_[c].norm_scales}, [&](const Solution& begun) {
                const double most = enough(begun);
                return weight > 0 ? std::min(most, multigrid::kHeldPart * wanted_residual * weight) : most;
              });
    return {std::move(step), std::move(solution)};
  };
  if (cloths_[c].levels.empty()) {
    LinearStep step =
        linearise(substep.system, substep.places, substep.dt, substep.ratio, c, pressed.presses, ways);
    return solved(step, Hierarchy(step.matrix, step.source, cloths_[c].bottom, cloths_[c].finest));
  }
  MeshStep step =
      linearise_mesh(substep.system, substep.places, substep.dt, substep.ratio, c, pressed.presses, ways);
  return solved(step, MeshHierarchy(step.matrix, cloths_[c].bottom, cloths_[c].finest));
}

void ImplicitStepper::forget(const std::vector<NearPair>& pairs) {
  for (const NearPair& pair : pairs)
    for (std::uint32_t k = 0; k < pair.node_count; ++k) known_[pair.nodes[k]] = false;
}

void ImplicitStepper::finish(const Substep& substep, const Solved& found, std::size_t c,
                             std::vector<Vec3d>& position, std::vector<Vec3d>& velocity,
                             std::vector<std::size_t>& stopped) {
  const Cloth& cloth = cloths_[c];
  const StepStart& step = found.step;
  const Field& dz = found.solution.x;
  for (std::size_t a = 0; a < dz.size(); ++a) {
    const std::size_t node = cloth.first + a;
    const StepFormula formula = step_formula(substep.dt, known_[node] ? substep.ratio : 0);
    position[node] = step.place[a] + step.start[a] + dz[a];
    velocity[node] = step.start_velocity[a] + (step.fixed[a] ? Vec3d{} : dz[a] / formula.he);
    hold_forces_[node] = {};
    if (!step.holds[a]) continue;
    const Hold::End end = step.holds[a]->end(dz[a]);
    hold_forces_[node] = end.force;
    velocity[node] = end.velocity;
    position[node] += end.stopped;
    held_[node] = step.holds[a]->alike();
    stopped.push_back(node);  // an impulse breaks the history of BDF2
  }
  for (const PairHold& hold : step.pairs) {
    const PairHold::End end = hold.end(dz, substep.dt);
    pair_forces_[hold.pair()] = end.force;
    hold.for_each_node([&](std::uint32_t a, double weight) {
      const std::size_t node = cloth.first + a;
      if (step.fixed[a]) return;
      velocity[node] += (weight * substep.system.inverse_mass[node]) * end.impulse;
      stopped.push_back(node);
    });
  }
}

void ImplicitStepper::keep_momentum(const Substep& substep, const std::vector<Solved>& found,
                                    const std::vector<Vec3d>& position, std::vector<Vec3d>& velocity) const {
  const MassSpringSystem& system = substep.system;
  if (system.drag != 0 || system.air || !system.gases.empty()) return;
  std::vector<bool> goes_free(position.size(), true);
  for (std::size_t c = 0; c < cloths_.size(); ++c)
    for (std::size_t a = 0; a < cloths_[c].count; ++a)
      goes_free[cloths_[c].first + a] = !found[c].step.fixed[a] && !found[c].step.holds[a];
  const double dt = substep.dt;
  const auto keep = [&](const FreePieces& pieces) {
    for_each_free_piece(
        pieces, [&](std::uint32_t node) { return goes_free[node]; },
        [&](std::uint32_t node) {
          const Vec3d fall = dt * dt * system.acceleration, after = dt * velocity[node];
          // A step of second order falls by half of that less than its velocity at the end says.
          const double less = known_[node] && substep.ratio > 0 ? 0.5 : 0;
          const Vec3d beside = position[node] - system.position[node] - after + less * fall;
          return NodeMotion{1 / system.inverse_mass[node], system.position[node],
                            after - dt * system.velocity[node] - fall, cross(beside, after)};
        },
        [&](std::span<const std::uint32_t> nodes, std::span<const NodeMotion> motions) {
          const PieceTurn turn = PieceTurn::of(motions);
          for (const std::uint32_t node : nodes) velocity[node] += turn.at(system.position[node]) / dt;
        });
  };
  if (substep.pressed) keep(joined_);
  for (std::size_t c = 0; c < cloths_.size(); ++c)
    for (const PairHold& hold : found[c].step.pairs)
      if (hold.is_of_two_bodies())
        hold.for_each_node([&](std::uint32_t a, double) { goes_free[cloths_[c].first + a] = false; });
  keep(pieces_);
}

std::vector<ImplicitStepper::Solved> ImplicitStepper::correct(const Substep& substep) {
  const auto pressed_by = [&](std::span<const Vec3d> velocities) {
    Pressed pressed = substep.pressed(velocities);
    forget(pressed.pairs);
    for (std::size_t node = 0; node < pressed.presses.size(); ++node)
      if (pressed.presses[node].weight > 0) known_[node] = false;
    return pressed;
  };
  const double wanted = multigrid::kHeldPart * wanted_residual;
  const Pressed at_first = pressed_by(substep.system.velocity);
  std::vector<Vec3d> ways(substep.system.position.size()), velocities(ways.size());
  std::vector<Solution> first;
  for (std::size_t c = 0; c < cloths_.size(); ++c) {
    Solved one = solved(substep, at_first, c, {}, multigrid::kFirstIterations, [&](const Solution& begun) {
      return enough_of(begun, std::max(wanted, multigrid::kFirstPart));
    });
    for (std::size_t a = 0; a < one.solution.x.size(); ++a) {
      const std::size_t node = cloths_[c].first + a;
      ways[node] = one.way(a);
      velocities[node] = ways[node] / substep.dt;
      if (!one.step.holds[a]) hold_forces_[node] = {};
    }
    first.push_back(std::move(one.solution));
  }
  const Pressed pressed = pressed_by(velocities);
  pair_forces_.assign(pressed.pairs.size(), {});
  std::vector<Solved> found;
  for (std::size_t c = 0; c < cloths_.size(); ++c) {
    found.push_back(solved(substep, pressed, c, ways, multigrid::kMostIterations,
                           [&](const Solution&) { return enough_of(first[c], wanted); }));
    found.back().solution.iterations += first[c].iterations;
    found.back().solution.first = first[c].first;
  }
  return found;
}

std::vector<ImplicitStepper::Solved> ImplicitStepper::newton(const Substep& substep) {
  std::vector<Vec3d> ways(substep.system.position.size());
  std::vector<Solved> found;
  for (std::size_t c = 0; c < cloths_.size(); ++c) {
    Solved step = solved(substep, {}, c, {}, multigrid::kFirstIterations, [&](const Solution& begun) {
      return enough_of(begun, std::max(wanted_residual, multigrid::kFirstPart));
    });
    const Solution first = step.solution;
    std::uint32_t iterations = 0, taken = 0;
    do {
      iterations += step.solution.iterations;
      ++taken;
      for (std::size_t a = 0; a < step.solution.x.size(); ++a) ways[cloths_[c].first + a] = step.way(a);
      step = solved(substep, {}, c, ways, taken < newton_steps_ ? multigrid::kMostIterations : 0,
                    [&](const Solution&) { return enough_of(first, wanted_residual); });
    } while (step.solution.iterations > 0);
    step.solution.iterations = iterations;
    step.solution.first = first.first;
    found.push_back(std::move(step));
  }
  return found;
}

void ImplicitStepper::advance(const Substep& substep) {
  MassSpringSystem& system = substep.system;
  yield(system);
  std::vector<Solved> found;
  pair_forces_.clear();
  if (substep.pressed) {
    found = correct(substep);
  } else if (newton_steps_ > 0) {
    found = newton(substep);
  } else {
    for (std::size_t c = 0; c < cloths_.size(); ++c)
      found.push_back(solved(substep, {}, c, {}, multigrid::kMostIterations,
                             [&](const Solution& begun) { return enough_of(begun, wanted_residual); }));
  }
  std::vector<Vec3d> position = system.position, velocity = system.velocity;
  std::vector<std::size_t> stopped;
  iterations_ = 0;
  residual_ = 0;
  held_.assign(substep.pressed ? position.size() : 0, false);
  for (std::size_t c = 0; c < cloths_.size(); ++c) {
    const Solution& solution = found[c].solution;
    iterations_ = std::max(iterations_, solution.iterations);
    if (solution.first > 0) residual_ = std::max(residual_, solution.left / solution.first);
    finish(substep, found[c], c, position, velocity, stopped);
  }
  keep_momentum(substep, found, position, velocity);
  remember(system.position, system.velocity);
  for (const std::size_t node : stopped) forget(node);
  system.position = std::move(position);
  system.velocity = std::move(velocity);
  system.time += substep.dt;
}

}  // namespace weft::reference
