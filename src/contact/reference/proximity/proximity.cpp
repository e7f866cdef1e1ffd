#include "contact/reference/proximity/proximity.hpp"

#include <algorithm>
#include <cmath>

#include "contact/reference/proximity/audit.hpp"
#include "contact/reference/proximity/turned_plane.hpp"
#include "contact/rules/contact_law.hpp"
#include "contact/rules/rigid_body.hpp"
#include "mesh/sheet_rim.hpp"

namespace weft::reference {
namespace {

// How far beyond a substep pairs are listed: a search serves for about as many substeps as the first says.
constexpr double kSlackTravels = 4, kSlackThickness = 0.25;

/// How far before a solid side its plane lies: equation (6).
double margin_of(double distance, double thickness) {
  return std::max(kContactMargin * std::min(distance, thickness), kContactFloor * thickness);
}

}  // namespace

Proximity::Proximity(const scene::Scene& scene, const Model& model,
                     std::span<const mesh::TriangleMesh> objects,
                     std::span<const mesh::Deformation> deformations, double step,
                     const SolvedContact& solved)
    : solved_(solved),
      thickness_(scene.contact.thickness),
      restitution_(scene.contact.restitution),
      load_(scene.gravity + scene.external_force),
      impulses_(impulse_rule(model, scene.contact, step)),
      push_times_(solved.pairs ? push_times(model) : PushTimes{}),
      separations_(contact_iterations(step)),
      limited_edges_(limited_edges(model)),
      cloth_(features_of(model.rest_position, model.triangles)),
      rest_(cloth_),
      obstacles_(scene, objects, deformations),
      rigid_(scene, objects),
      yielding_(rigid_.empty() ? yielding_edges(model, step) : YieldingEdges{}),
      object_(obstacles_.features()),
      cloth_facts_{rim_distances(model.rest_position, model.triangles),
                   std::vector(model.vertex_count(), SurfaceKind::Cloth), opposite_corners(model.triangles)} {
  object_.most_spare = kMostSpare * thickness_;
  for (const mesh::TriangleMesh& mesh : objects) {
    const std::vector<Vec3d> places = widened(mesh.positions);
    for (const double rim : rim_distances(places, mesh.triangles)) object_facts_.rims.push_back(rim);
    object_facts_.kinds.resize(object_facts_.rims.size(), faces_outward(places, mesh.triangles)
                                                              ? SurfaceKind::ClosedMesh
                                                              : SurfaceKind::OpenMesh);
  }
  object_facts_.kinds.resize(object_.positions.size(), SurfaceKind::OpenMesh);  // balls have no triangles
  if (scene.contact.self) self_thickness_ = weft::self_thickness(model, thickness_);
  for (std::size_t c = 0; c < model.bodies.size(); ++c) {
    body_.insert(body_.end(), model.bodies[c].vertex_count, static_cast<std::uint32_t>(c));
    cloth_.cloths.insert(cloth_.cloths.end(), model.bodies[c].vertex_count,
                         contact_number(model, c, solved.pairs));
    friction_.insert(friction_.end(), model.bodies[c].vertex_count, scene.cloths[c].friction);
  }
  cloth_facts_.rest = model.rest_position;
  cloth_facts_.bodies = body_;
  cloth_facts_.touching = kTouchingAtRest * self_thickness_;
}

double Proximity::move_obstacles(double begin, double dt) {
  if (start_.transforms.empty() || !obstacles_.still()) {
    start_ = obstacles_.at(begin);
    end_ = obstacles_.at(begin + dt);
    if (!rigid_.empty()) {
      rigid_.go({dt, load_, restitution_, thickness_, start_.transforms, end_.transforms});
      start_ = obstacles_.at(begin, rigid_.starts());
      end_ = obstacles_.at(begin + dt, rigid_.ends());
    }
    object_.positions = start_.positions;
  }
  double most = 0;
  for (std::size_t v = 0; v < start_.positions.size(); ++v)
    most = std::max(most, length(end_.positions[v] - start_.positions[v]));
  return most;
}

Proximity::Sides Proximity::sides_of(const FeaturePair& pair) const {
  const auto side = [](const auto& vertices, const std::array<double, 3>& weights, bool obstacle) {
    Side made{static_cast<std::uint32_t>(vertices.size()), {}, weights, obstacle};
    std::copy(vertices.begin(), vertices.end(), made.vertices.begin());
    return made;
  };
  const std::array<std::uint32_t, 1> vertex{pair.a};
  const auto &wa = pair.weights_a, &wb = pair.weights_b;
  switch (pair.kind) {
    case PairKind::VertexTriangle:
      return {side(vertex, wa, false), side(cloth_.triangles[pair.b], wb, false)};
    case PairKind::EdgeEdge:
      return {side(cloth_.edges[pair.a], wa, false), side(cloth_.edges[pair.b], wb, false)};
    case PairKind::VertexObjectTriangle:
      return {side(vertex, wa, false), side(object_.triangles[pair.b], wb, true)};
    case PairKind::ObjectVertexTriangle:
      return {side(vertex, wa, true), side(cloth_.triangles[pair.b], wb, false)};
    case PairKind::EdgeObjectEdge:
      return {side(cloth_.edges[pair.a], wa, false), side(object_.edges[pair.b], wb, true)};
    case PairKind::VertexBall:
      return {side(vertex, wa, false), side(std::array{pair.b}, wb, true)};
    case PairKind::VertexCapsule:
      return {side(vertex, wa, false), side(object_.edges[pair.b], wb, true)};
    case PairKind::VertexPlane:
      break;
  }
  return {side(vertex, wa, false), Side{0, {}, {}, true}};
}

Proximity::Surface Proximity::surface_of(const FeaturePair& pair, const Sides& sides,
                                         const Vec3d& toward_cloth, double dt) const {
  if (pair.kind == PairKind::VertexPlane) {
    const std::uint32_t collider = obstacles_.collider_of_plane(pair.b);
    const Vec3d point = cloth_.positions[pair.a] - pair.distance * pair.direction;
    const Vec3d after = carried(point, start_.transforms[collider], end_.transforms[collider]);
    return {(after - point) / dt, dot(toward_cloth, after)};
  }
  const Side& side = sides.a.obstacle ? sides.a : sides.b;
  const double radius = object_.radius_of_vertex(side.vertices[0]);
  Vec3d before, after;
  double support = 0;
  for (std::uint32_t k = 0; k < side.count; ++k) {
    const std::uint32_t vertex = side.vertices[k];
    before += std::abs(side.weights[k]) * start_.positions[vertex];
    after += std::abs(side.weights[k]) * end_.positions[vertex];
    const double reached = dot(toward_cloth, end_.positions[vertex]);
    support = k == 0 ? reached : std::max(support, reached);
  }
  if (radius > 0) {  // a body that turns: its surface moves otherwise than its axis
    const std::uint32_t collider = obstacles_.collider_of_vertex(side.vertices[0]);
    before += radius * toward_cloth;
    after = carried(before, start_.transforms[collider], end_.transforms[collider]);
  }
  return {(after - before) / dt, support + radius};
}

double Proximity::friction_of(const FeaturePair& pair, const Sides& sides) const {
  const Side& cloth = sides.a.obstacle ? sides.b : sides.a;
  const double own = friction_[cloth.vertices[0]];
  if (pair.kind == PairKind::VertexPlane)
    return obstacles_.friction(obstacles_.collider_of_plane(pair.b)).value_or(own);
  const Side& other = sides.a.obstacle ? sides.a : sides.b;
  if (!other.obstacle) return rigid_friction(own, friction_[other.vertices[0]]);
  return obstacles_.friction(obstacles_.collider_of_vertex(other.vertices[0])).value_or(own);
}

double Proximity::thickness_of(const FeaturePair& pair, const Sides& sides) const {
  if (body_[sides.a.vertices[0]] != body_[sides.b.vertices[0]]) return self_thickness_;
  return pair_thickness(self_thickness_, measured(pair, rest_, object_).distance);
}

const Proximity::Kept* Proximity::force_of(const std::vector<Kept>& sorted, const FeaturePair& pair) {
  const auto found =
      std::lower_bound(sorted.begin(), sorted.end(), pair,
                       [](const Kept& one, const FeaturePair& other) { return one.pair < other; });
  return found != sorted.end() && same_features(found->pair, pair) ? &*found : nullptr;
}

std::vector<Proximity::Kept> Proximity::solved_pairs(std::span<const Vec3d> forces) const {
  std::vector<Kept> solved;
  for (std::size_t p = 0; p < forces.size(); ++p)
    if (forces[p] != Vec3d{}) solved.push_back({pressed_[p].features, forces[p]});
  std::sort(solved.begin(), solved.end(), [](const Kept& a, const Kept& b) { return a.pair < b.pair; });
  return solved;
}

std::vector<NearPair> Proximity::pressed_pairs() const {
  std::vector<NearPair> pairs;
  for (const Pressed& one : pressed_) pairs.push_back(one.near);
  return pairs;
}

NearPair Proximity::near_pair(const FeaturePair& pair, const Sides& sides, bool untangles, double dt) const {
  NearPair near;
  for (const Side* side : {&sides.a, &sides.b})
    for (std::uint32_t k = 0; !side->obstacle && k < side->count; ++k) {
      near.nodes[near.node_count] = side->vertices[k];
      near.weights[near.node_count++] = side->weights[k];
    }
  const bool with_obstacle = sides.a.obstacle || sides.b.obstacle;
  near.with_body = with_obstacle;
  if (!with_obstacle) {
    const std::uint32_t a = cloth_.cloths[near.nodes[0]], b = cloth_.cloths[near.nodes[near.node_count - 1]];
    near.of_one_system = are_of_one_system(a, b);
    near.of_bodies = (a & b & kIsJoined) != 0;
    near.of_two_bodies = near.of_bodies && a != b;
  }
  near.direction = pair.direction;
  near.distance = pair.distance;
  near.thickness = with_obstacle ? thickness_ : untangles ? self_thickness_ : thickness_of(pair, sides);
  near.untangles = untangles;
  near.friction = friction_of(pair, sides);
  if (const Kept* kept = force_of(kept_, pair)) near.kept = kept->force;
  near.may = pair.inside && pair.in_cones && near.thickness > 0;
  if (with_obstacle) {
    const double sign = sides.a.obstacle ? 1 : -1;
    const Vec3d velocity = surface_of(pair, sides, -sign * pair.direction, dt).velocity;
    near.surface = sign * velocity;
    near.rigid = rigid_of(pair, sides);
    if (near.rigid) {
      const Movable& body = rigid_.movables()[near.rigid->collider];
      near.surface = sign * (body.velocity + cross(body.spin, near.rigid->arm));
    }
    near.round = axis_of(sides);
    if (!near.round) near.curved = curved_of(pair, sides, velocity, dt);
  }
  return near;
}

std::optional<NearPair::Rigid> Proximity::rigid_of(const FeaturePair& pair, const Sides& sides) const {
  if (rigid_.empty() || pair.kind == PairKind::VertexPlane) return {};
  const bool on_a = sides.a.obstacle;
  const Side &obstacle = on_a ? sides.a : sides.b, &cloth = on_a ? sides.b : sides.a;
  if (!obstacle.obstacle) return {};
  const std::size_t collider = obstacles_.collider_of_vertex(obstacle.vertices[0]);
  if (!rigid_.solids()[collider].rigid()) return {};
  Vec3d place;
  for (std::uint32_t k = 0; k < cloth.count; ++k)
    place += std::abs(cloth.weights[k]) * cloth_.positions[cloth.vertices[k]];
  return NearPair::Rigid{collider, on_a ? 1.0 : -1.0, place - rigid_.movables()[collider].place};
}

std::optional<RoundAxis> Proximity::axis_of(const Sides& sides) const {
  const Side& side = sides.a.obstacle ? sides.a : sides.b;
  if (side.count == 0 || side.count > 2 || !(object_.radius_of_vertex(side.vertices[0]) > 0)) return {};
  const std::uint32_t first = side.vertices[0], last = side.vertices[side.count - 1];
  return RoundAxis{{start_.positions[first], start_.positions[last]},
                   {end_.positions[first], end_.positions[last]}};
}

std::optional<CurvedSurface> Proximity::curved_of(const FeaturePair& pair, const Sides& sides,
                                                  const Vec3d& velocity, double dt) const {
  if (pair.kind == PairKind::VertexPlane) return {};
  const bool on_a = sides.a.obstacle;
  const Side &obstacle = on_a ? sides.a : sides.b, &cloth = on_a ? sides.b : sides.a;
  const std::uint32_t collider = obstacles_.collider_of_vertex(obstacle.vertices[0]);
  CurvedSurface surface{
      .velocity = velocity,
      .spin = scene::spin_between(start_.transforms[collider], end_.transforms[collider], dt)};
  const double* r = start_.transforms[collider].rotation;
  const Mat3 turn{{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, {r[6], r[7], r[8]}};
  Vec3d normal;
  for (std::uint32_t k = 0; k < obstacle.count; ++k) {
    const mesh::Curvature& at = obstacles_.curvature(obstacle.vertices[k]);
    if (std::abs(dot(turn * at.normal, pair.direction)) < mesh::kSameSector) continue;
    normal += std::abs(obstacle.weights[k]) * at.normal;
    surface.shape += std::abs(obstacle.weights[k]) * at.shape;
  }
  for (std::uint32_t k = 0; k < cloth.count; ++k)
    surface.place += std::abs(cloth.weights[k]) * cloth_.positions[cloth.vertices[k]];
  const Vec3d toward = on_a ? -pair.direction : pair.direction;
  const double side = dot(turn * normal, toward) < 0 ? -1 : 1;
  surface.shape = side * (turn * surface.shape * transposed(turn));
  return surface;
}

Vec3d Proximity::across(const FeaturePair& pair, double thickness, std::span<const Vec3d> expected) const {
  const Sides sides = sides_of(pair);
  const Side& obstacle = sides.a.obstacle ? sides.a : sides.b;
  if (obstacle.count == 0 || object_.radius_of_vertex(obstacle.vertices[0]) > 0) return pair.direction;
  MovingPair moving{sides.a.count, sides.b.count, {}, {}};
  std::uint32_t corner = 0;
  for (const Side* side : {&sides.a, &sides.b})
    for (std::uint32_t k = 0; k < side->count; ++k, ++corner) {
      const std::uint32_t vertex = side->vertices[k];
      moving.start[corner] = side->obstacle ? start_.positions[vertex] : cloth_.positions[vertex];
      moving.end[corner] = side->obstacle ? end_.positions[vertex] : expected[vertex];
    }
  return turned_normal(moving, pair.direction, pair.distance, margin_of(pair.distance, thickness));
}

void Proximity::add_limits(const FeaturePair& pair, const NearPair& near, bool acts, const Nodes& nodes,
                           std::span<const Vec3d> expected, double dt, std::vector<SolidPlane>& planes,
                           std::vector<ClothPair>& cloth) const {
  const double thickness = near.thickness;
  // Inside a ball or below a plane pushes move it out.
  if (!(pair.distance > 0) || !(thickness > 0)) return;
  const Sides sides = sides_of(pair);
  const auto kinematic = [&](const Side& side) {
    return std::all_of(side.vertices.begin(), side.vertices.begin() + side.count,
                       [&](std::uint32_t v) { return nodes.inverse_mass[v] == 0; });
  };
  bool of_cloth = !sides.a.obstacle && !sides.b.obstacle;
  for (const bool other_is_a : {true, false}) {
    const Side &side = other_is_a ? sides.b : sides.a, &other = other_is_a ? sides.a : sides.b;
    if (side.obstacle || !(other.obstacle || kinematic(other))) continue;
    of_cloth = false;
    const Vec3d direction = acts || !other.obstacle ? pair.direction : across(pair, thickness, expected);
    const Vec3d away = other_is_a ? -direction : direction;  // from the other side to this one
    double offset = 0, speed = 0;
    if (other.obstacle) {
      const Surface surface = surface_of(pair, sides, away, dt);
      offset = surface.support + margin_of(pair.distance, thickness);
      speed = dot(away, surface.velocity);
    } else {  // cloth that only its motion moves is an obstacle
      for (std::uint32_t k = 0; k < other.count; ++k) {
        const double along = dot(away, nodes.position[other.vertices[k]]);
        offset = k == 0 ? along : std::max(offset, along);
        speed += std::abs(other.weights[k]) * dot(away, nodes.velocity[other.vertices[k]]);
      }
      offset += margin_of(pair.distance, thickness);
    }
    const std::optional<NearPair::Rigid> rigid = rigid_of(pair, sides);
    for (std::uint32_t k = 0; k < side.count; ++k)
      planes.push_back({side.vertices[k], away, offset, speed, rigid ? rigid->collider : kNoCollider,
                        thickness, !other.obstacle});
  }
  if (!of_cloth) return;
  ClothPair both{sides.a.count, sides.b.count, {}, pair.direction};
  for (std::uint32_t k = 0; k < sides.a.count; ++k) {
    both.nodes[k] = sides.a.vertices[k];
    both.middle += sides.a.weights[k] * dot(pair.direction, cloth_.positions[sides.a.vertices[k]]);
  }
  for (std::uint32_t k = 0; k < sides.b.count; ++k) both.nodes[sides.a.count + k] = sides.b.vertices[k];
  both.middle -= 0.5 * pair.distance;
  both.margin = std::max(kContactMargin * pair.distance, 0.5 * kContactFloor * thickness);
  both.apart = std::min(2 * both.margin, pair.distance);  // what is nearer already comes no nearer
  both.gap = pair.distance;
  both.tangled = std::any_of(both.nodes.begin(), both.nodes.begin() + both.count_a + both.count_b,
                             [&](std::uint32_t v) { return tangle_.with_cloth[v] || tangle_.with_mesh[v]; });
  both.of_two_bodies = near.of_two_bodies;
  cloth.push_back(both);
}

std::vector<FeaturePair> Proximity::listed(double most, double travel, double obstacle_travel) {
  const double self_reach = self_thickness_ > 0 ? self_thickness_ + 2 * most : 0;
  const double slack = kSlackTravels * std::max(travel, obstacle_travel) + kSlackThickness * thickness_;
  return list_.near(cloth_, object_, {self_reach, thickness_ + most + obstacle_travel}, slack);
}

std::vector<Press> Proximity::presses(std::span<const Vec3d> position, std::span<const Vec3d> velocity,
                                      double begin, double dt) {
  cloth_.positions.assign(position.begin(), position.end());
  double travel = 0;
  for (const Vec3d& v : velocity) travel = std::max(travel, dt * length(v));
  const double most = travel + 0.5 * thickness_, obstacle_travel = move_obstacles(begin, dt);
  std::vector<FeaturePair> pairs = listed(most, travel, obstacle_travel);
  const std::vector<FeaturePair> with_planes =
      plane_pairs(cloth_, start_.planes, thickness_ + most + obstacle_travel);
  pairs.insert(pairs.end(), with_planes.begin(), with_planes.end());
  std::vector<NearPair> near;
  for (const FeaturePair& pair : pairs) near.push_back(near_pair(pair, sides_of(pair), false, dt));
  pressed_.clear();
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const NearPair& one = near[p];
    if (!one.of_one_system || !one.may || !(one.distance > 0)) continue;
    if (tangle_.crossings > 0 && one.kept == Vec3d{}) continue;  // it may be on the wrong side
    const double way = dt * dot(one.direction, relative_velocity(one, velocity));
    if (one.distance + std::min(way, 0.0) < kContactTouching * one.thickness)
      pressed_.push_back({pairs[p], one});
  }
  return presses_of(near, position, velocity, dt, solved_.own_pairs);
}

bool Proximity::is_held(const NearPair& pair, const std::vector<bool>& held) const {
  if (held.empty() || !pair.with_body || pair.untangles) return false;
  if (!(pair.distance < kContactTouching * pair.thickness)) return false;
  bool any = false, all = true;
  for (std::uint32_t k = 0; k < pair.node_count; ++k) {
    if (pair.weights[k] == 0) continue;
    any = any || held[pair.nodes[k]];
    all = all && held[pair.nodes[k]];
  }
  return any && (all || !solved_.own_pairs);
}

std::uint64_t Proximity::answer(const Nodes& nodes, double begin, double dt) {
  beside_cloth_.clear();
  if (obstacles_.empty() && self_thickness_ == 0) return 0;
  cloth_.positions.assign(nodes.previous.begin(), nodes.previous.end());
  double travel = 0;
  for (std::size_t i = 0; i < nodes.position.size(); ++i)
    travel = std::max(travel, length(nodes.position[i] - nodes.previous[i]));
  // An impulse may make a node faster than any was, or as fast as an obstacle: this much more is listed for, and none
  // goes further.
  const double obstacle_travel = move_obstacles(begin, dt);
  const double most = std::max(travel, obstacle_travel) + 0.5 * thickness_;
  std::vector<FeaturePair> pairs = listed(most, travel, obstacle_travel);
  const TangledSurfaces cloth{cloth_, cloth_facts_}, object{object_, object_facts_};
  // Without crossings, only features that come near can cross.
  if (list_.searches() != tangle_searched_ || tangle_.crossings > 0)
    tangle_ = find_tangle(cloth, object, self_thickness_ > 0);
  tangle_searched_ = list_.searches();
  std::vector<bool> untangles = release(tangle_, cloth, object, thickness_, pairs);
  pairs.insert(pairs.end(), tangle_.pairs.begin(), tangle_.pairs.end());
  untangles.resize(pairs.size(), true);
  const std::vector<FeaturePair> with_planes =
      plane_pairs(cloth_, start_.planes, thickness_ + most + obstacle_travel);
  pairs.insert(pairs.end(), with_planes.begin(), with_planes.end());
  untangles.resize(pairs.size(), false);
  std::vector<NearPair> near;
  for (std::size_t p = 0; p < pairs.size(); ++p)
    near.push_back(near_pair(pairs[p], sides_of(pairs[p]), untangles[p], dt));
  for (NearPair& pair : near) pair.held = is_held(pair, nodes.held);
  const std::vector<Kept> solved = solved_pairs(nodes.pair_forces);
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const Kept* found = near[p].with_body || near[p].untangles ? nullptr : force_of(solved, pairs[p]);
    near[p].solved = found != nullptr;
    if (found != nullptr) near[p].kept = found->force;
  }
  std::vector<Vec3d> expected;
  for (std::size_t i = 0; i < nodes.position.size(); ++i)
    expected.push_back(nodes.previous[i] + dt * nodes.velocity[i]);
  Response response = respond(near, nodes.velocity, nodes.inverse_mass,
                              {dt, restitution_, load_, impulses_, push_times_}, rigid_.movables());
  kept_.clear();
  for (std::size_t p = 0; p < pairs.size(); ++p)
    if (response.acts[p] && !near[p].untangles) kept_.push_back({pairs[p], response.impulses[p] / dt});
  std::sort(kept_.begin(), kept_.end(), [](const Kept& a, const Kept& b) { return a.pair < b.pair; });
  for (std::size_t i = 0; i < nodes.position.size(); ++i) {
    if (nodes.inverse_mass[i] == 0) continue;
    nodes.velocity[i] += response.change[i];
    // After an implicit solve of obstacles and pairs springs are in balance: an impulse changes the velocity alone, and
    // the next substep moves the node with its neighbours. What an obstacle strikes would be in it by then, and cloth
    // that other cloth bears has no other hold: these go along.
    const bool moves =
        nodes.held.empty() || !solved_.balances || response.beside_cloth[i] || response.struck[i];
    nodes.position[i] += (moves ? dt : 0) * response.change[i] + response.push[i];
  }
  std::vector<SolidPlane> planes;
  std::vector<ClothPair> cloth_pairs;
  for (std::size_t p = 0; p < pairs.size(); ++p)
    add_limits(pairs[p], near[p], response.acts[p], nodes, expected, dt, planes, cloth_pairs);
  // A truncated vertex has not moved by its velocity. Kept, that velocity feeds the springs: in a pull over a ball at
  // steps so long that contacts go 2 mm each, nodes came to 20 m/s and the energy rose. So it is shortened too.
  const Truncated truncated = truncate(
      planes, cloth_pairs, most,
      {nodes.previous, nodes.inverse_mass, nodes.position, nodes.velocity, dt, separations_, limited_edges_,
       tangle_.crossings > 0 ? 0 : most_delay_, nodes.velocity_before, yielding_.edges, yielding_.time});
  if (!rigid_.empty()) {
    std::vector<RigidImpulse> impulses = response.body_impulses;
    for (const Truncated::Taken& taken : truncated.taken) {
      const Vec3d arm = nodes.previous[taken.node] - rigid_.movables()[taken.collider].place;
      impulses[taken.collider].linear += taken.impulse;
      impulses[taken.collider].angular += cross(arm, taken.impulse);
    }
    std::vector<std::optional<double>> lacks(impulses.size());
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      if (!near[p].rigid || !response.acts[p] || near[p].untangles) continue;
      const auto& [collider, weight, arm] = *near[p].rigid;
      if (!rigid_.bears(collider, weight * near[p].direction)) continue;
      const double lack = std::max(near[p].thickness - near[p].distance, -near[p].thickness);
      lacks[collider] = std::max(lacks[collider].value_or(lack), lack);
    }
    rigid_.arrive(impulses, response.body_pushes, lacks, truncated.part, dt);
  }
  truncated_.vertices += truncated.vertices;
  truncated_.driven += truncated.driven;
  truncated_.delay += truncated.delay;
  most_delay_ -= truncated.delay;
  met_ = truncated.met;
  beside_cloth_ = std::move(response.beside_cloth);
  return static_cast<std::uint64_t>(std::count(response.acts.begin(), response.acts.end(), true));
}

}  // namespace weft::reference
