// The expected result of a search, and checks of the real one: triangles by their boxes in the kernel's arithmetic,
// features by brute force in double.
#pragma once

#include <cmath>
#include <cstdio>
#include <limits>

#include "contact/motion_sets.hpp"
#include "contact/proximity/feature_owners.hpp"
#include "contact/rules/contact_law.hpp"
#include "contact/search_fixture.hpp"
#include "state/hash_pair.hpp"

namespace weft {

using NumberPair = std::array<std::uint32_t, 2>;

inline bool finite(const Vec3f& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

struct BoxF {
  Vec3f low, high;
  bool whole = true;  // all corners are finite
};
inline BoxF box_of(const std::vector<Vec3f>& positions, const mesh::Triangle& t) {
  const Vec3f &a = positions[t[0]], &b = positions[t[1]], &c = positions[t[2]];
  return {min(min(a, b), c), max(max(a, b), c), finite(a) && finite(b) && finite(c)};
}
/// Rounded as in f32, so that the kernel's comparison is this one; each box is grown by its own.
inline bool boxes_meet(const BoxF& own, const BoxF& other, float radius, float other_radius = 0) {
  if (!own.whole || !other.whole) return false;
  for (int axis = 0; axis < 3; ++axis)
    if (!(own.low[axis] - radius <= other.high[axis] + other_radius &&
          other.low[axis] - other_radius <= own.high[axis] + radius))
      return false;
  return true;
}

/// Of all that a cloth triangle may pass on its corners' ways ahead.
inline BoxF swept_box(const SearchFound& found, const mesh::Triangle& t) {
  BoxF box{found.places[t[0]].xyz(), found.places[t[0]].xyz()};
  for (const std::uint32_t v : t) {
    const Vec3f p = found.places[v].xyz();
    box.low = min(box.low, min(p, p + found.aheads[v]));
    box.high = max(box.high, max(p, p + found.aheads[v]));
    box.whole = box.whole && finite(p);
  }
  return box;
}
/// The largest of the corners' [m].
inline float slack_of(const SearchFound& found, const mesh::Triangle& t) {
  return std::max(std::max(found.places[t[0]].w, found.places[t[1]].w), found.places[t[2]].w);
}
inline double longest_ahead(const SearchFound& found, const mesh::Triangle& t) {
  double most = 0;
  for (const std::uint32_t v : t) most = std::max(most, length(found.aheads[v].to<double>()));
  return most;
}

enum class Flat { No, Yes, Doubtful };
/// The least distance of features of two triangles on a common edge that share no vertex, from below [m]; negative
/// for others. Laid flat the triangles are on either side of the edge, and no features are nearer than the shortest
/// altitude a: of segments that do not cross an end is nearest. Let points of either be x and y from the edge's line,
/// and z apart along it; bent, with c the cosine between the faces (1: flat), they are
///   z^2 + x^2 + y^2 + 2 c x y >= z^2 + (1 + c) / 2 (x + y)^2
/// from each other squared, since x^2 + y^2 >= (x + y)^2 / 2: no nearer than sqrt((1 + c) / 2) a.
inline double least_distance_of_neighbours(const std::vector<Vec3f>& positions, const mesh::Triangle& x,
                                           const mesh::Triangle& y) {
  const auto has = [](const mesh::Triangle& t, std::uint32_t v) {
    return std::find(t.begin(), t.end(), v) != t.end();
  };
  std::vector<Vec3d> shared;
  Vec3d tip_x, tip_y;
  for (const std::uint32_t v : x) {
    const Vec3d p = positions[v].to<double>();
    if (has(y, v))
      shared.push_back(p);
    else
      tip_x = p;
  }
  for (const std::uint32_t v : y)
    if (!has(x, v)) tip_y = positions[v].to<double>();
  if (shared.size() != 2) return -1;
  const Vec3d along = shared[1] - shared[0];
  const auto altitude = [&](const Vec3d& tip) {
    const Vec3d to_tip = tip - shared[0];
    const double longest = std::max({length(along), length(to_tip), length(to_tip - along)});
    return longest > 0 ? length(cross(to_tip, along)) / longest : 0.0;
  };
  const Vec3d area_x = cross(tip_x - shared[0], along), area_y = cross(tip_y - shared[0], along);
  const double areas = length(area_x) * length(area_y);
  if (!(areas > 0)) return 0;
  const double cosine = -dot(area_x, area_y) / areas;
  return std::sqrt(std::max(0.0, 0.5 * (1 + cosine))) * std::min(altitude(tip_x), altitude(tip_y));
}
/// Whether the broad phase leaves two triangles of cloth out; doubtful where f32 may see it otherwise.
inline Flat lie_flat(const SearchCase& setup, const SearchFound& found, const mesh::Triangle& x,
                     const mesh::Triangle& y) {
  double size = 0;
  for (const mesh::Triangle* t : {&x, &y})
    for (const std::uint32_t v : *t)
      size = std::max(size, length((found.places[v].xyz() - found.places[x[0]].xyz()).to<double>()));
  const double way = setup.self_thickness + slack_of(found, x) + longest_ahead(found, x) +
                     slack_of(found, y) + longest_ahead(found, y);
  const double apart = least_distance_of_neighbours(setup.cloth.positions, x, y);
  if (apart < 0) return Flat::No;
  // Near a fold the root turns the cosine's rounding, a few 2^-24, into its root.
  if (std::abs(apart - way) < 1e-5 * (way + size) + 2e-3 * (apart < 0.02 * size ? size : 0))
    return Flat::Doubtful;
  return apart > way ? Flat::Yes : Flat::No;
}

/// Candidates as numbers of triangles in their meshes; of cloth with itself the lower first.
struct NamedCandidates {
  std::vector<NumberPair> self;
  std::vector<std::vector<NumberPair>> objects;  // cloth triangle, object triangle; for each object
  std::size_t shapes = 0;                        // with spheres, capsules, planes
};

inline NamedCandidates named(const SearchFound& found, const SearchRun& run) {
  const SearchCase& setup = run.setup();
  const contact::ColliderSet& set = run.search().colliders();
  const std::vector<std::uint32_t>& order = run.search().order();
  const std::size_t cloth_words =
      contact::ImplicitTree(static_cast<std::uint32_t>(order.size())).words().size();
  // Of the points of an object's triangle: object and triangle.
  std::map<std::array<std::uint32_t, 3>, NumberPair> by_points;
  for (std::uint32_t o = 0; o < setup.objects.size(); ++o)
    for (std::uint32_t t = 0; t < setup.objects[o].triangles.size(); ++t) {
      mesh::Triangle points = setup.objects[o].triangles[t];
      for (std::uint32_t& p : points) p += run.first_point(o);
      by_points[points] = {o, t};
    }
  NamedCandidates names;
  names.objects.resize(setup.objects.size());
  for (const auto& [x, y] : found.candidates) {
    const std::uint32_t kind = x >> 28U, place = x & 0x0fffffffU;
    REQUIRE(place < order.size());
    if (kind == 0) {
      REQUIRE(y < order.size());
      names.self.push_back({std::min(order[place], order[y]), std::max(order[place], order[y])});
    } else if (kind <= 2) {
      std::array<std::uint32_t, 3> points{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& triangle = kind == 2 ? set.triangles.at(y - order.size()) : contact::TreeWord{};
        points[k] = kind == 1 ? set.trees.at(y - cloth_words + k).w & kIdBits
                              : std::array{triangle.x, triangle.y, triangle.z}[k];
      }
      const auto at = by_points.find(points);
      REQUIRE(at != by_points.end());
      names.objects[at->second[0]].push_back({order[place], at->second[1]});
    } else {
      ++names.shapes;
    }
  }
  std::sort(names.self.begin(), names.self.end());
  for (auto& list : names.objects) std::sort(list.begin(), list.end());
  return names;
}

inline std::uint32_t hash_of(const std::vector<NumberPair>& pairs) {
  std::uint32_t hash = 0;
  for (const auto& [a, b] : pairs) hash += hash_pair(a, b);
  return hash;
}

inline void check_same(const std::vector<NumberPair>& found, const std::vector<NumberPair>& expected) {
  CHECK(found.size() == expected.size());
  CHECK(hash_of(found) == hash_of(expected));
  if (found == expected) return;
  const auto at =
      std::mismatch(found.begin(), found.begin() + std::ptrdiff_t(std::min(found.size(), expected.size())),
                    expected.begin());
  const auto name = [](auto it, auto end) {
    return it == end ? std::string("nothing")
                     : std::to_string((*it)[0]) + " with " + std::to_string((*it)[1]);
  };
  FAIL_CHECK("first difference: found ", name(at.first, found.end()), ", expected ",
             name(at.second, expected.end()));
}

struct CandidateCount {
  std::size_t expected = 0, flat = 0;  // the second: left out
};

/// The cloth's candidates are those of brute force, but for neighbours of which f32 may not know whether they
/// lie flat.
inline CandidateCount check_self_candidates(const SearchFound& found, const NamedCandidates& names,
                                            const SearchRun& run) {
  const SearchCase& setup = run.setup();
  const std::vector<std::uint32_t>& order = run.search().order();
  std::vector<NumberPair> expected, doubtful;
  std::vector<BoxF> boxes;
  std::vector<float> slack;
  CandidateCount count;
  for (const std::uint32_t t : order) {
    boxes.push_back(swept_box(found, setup.cloth.triangles[t]));
    slack.push_back(slack_of(found, setup.cloth.triangles[t]));
  }
  for (std::uint32_t i = 0; setup.self_thickness > 0 && i < order.size(); ++i)
    for (std::uint32_t j = i + 1; j < order.size(); ++j) {
      if (!boxes_meet(boxes[i], boxes[j], setup.self_thickness + slack[i], slack[j])) continue;
      const Flat flat =
          lie_flat(setup, found, setup.cloth.triangles[order[i]], setup.cloth.triangles[order[j]]);
      const NumberPair pair{std::min(order[i], order[j]), std::max(order[i], order[j])};
      if (flat == Flat::No) expected.push_back(pair);
      if (flat == Flat::Doubtful) doubtful.push_back(pair);
      if (flat == Flat::Yes) ++count.flat;
    }
  std::sort(doubtful.begin(), doubtful.end());
  for (const NumberPair& pair : doubtful)
    if (std::binary_search(names.self.begin(), names.self.end(), pair)) expected.push_back(pair);
  std::sort(expected.begin(), expected.end());
  CHECK(doubtful.size() * 100 <= expected.size() + count.flat + 100);
  check_same(names.self, expected);
  count.expected = expected.size();
  return count;
}

/// The candidates with an object whose points stand where the mesh has them; gives their number.
inline std::size_t check_object_candidates(const SearchFound& found, const NamedCandidates& names,
                                           const SearchRun& run, std::size_t object) {
  const SearchCase& setup = run.setup();
  const mesh::TriangleMesh& mesh = setup.objects[object];
  std::vector<NumberPair> expected;
  for (std::uint32_t i = 0; i < setup.cloth.triangles.size(); ++i)
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      if (boxes_meet(swept_box(found, setup.cloth.triangles[i]), box_of(mesh.positions, mesh.triangles[t]),
                     setup.thickness + slack_of(found, setup.cloth.triangles[i]) + found.statistics.reach))
        expected.push_back({i, t});
  check_same(names.objects[object], expected);
  return expected.size();
}

/// A pair of features by its kind and vertices, whichever way round they were named.
using FeatureKey = std::array<std::uint32_t, 5>;

inline bool is_crossing(const ListedPair& pair) { return (pair.ids[2] & kCrossingFlag) != 0; }
/// The distance that a pair without record keeps [m].
inline float thickness_of(const ListedPair& pair) {
  float thickness = 0;
  std::memcpy(&thickness, &pair.words[0], sizeof thickness);
  return thickness;
}

inline FeatureKey corner_key(std::uint32_t vertex, std::array<std::uint32_t, 3> face) {
  std::sort(face.begin(), face.end());
  return {0, vertex, face[0], face[1], face[2]};
}
inline FeatureKey edge_key(std::array<std::uint32_t, 2> a, std::array<std::uint32_t, 2> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  if (b < a) std::swap(a, b);
  return {1, a[0], a[1], b[0], b[1]};
}
inline FeatureKey key_of(const std::array<std::uint32_t, 4>& ids) {
  if ((ids[1] & kPairFlag) != 0) return {2, ids[0], ids[1] & ~kPairFlag, ids[2], 0};
  if ((ids[0] & kPairFlag) != 0) return edge_key({ids[0] & ~kPairFlag, ids[1]}, {ids[2], ids[3]});
  return corner_key(ids[0], {ids[1], ids[2], ids[3]});
}

/// Cloth and obstacles as the reference has them, and the search's id of each obstacle's position.
struct Scenery {
  reference::Features cloth, object;
  std::vector<std::uint32_t> ids;
  std::vector<scene::ColliderPlane> planes;
  std::vector<std::uint32_t> plane_ids;
};

inline Scenery scenery_of(const SearchRun& run) {
  const SearchCase& setup = run.setup();
  const auto widened = [](const std::vector<Vec3f>& list) {
    std::vector<Vec3d> wide;
    for (const Vec3f& p : list) wide.push_back(p.to<double>());
    return wide;
  };
  Scenery scenery;
  scenery.cloth = reference::features_of(widened(setup.cloth.positions), setup.cloth.triangles);
  std::vector<Vec3d> positions;
  std::vector<mesh::Triangle> triangles;
  for (const mesh::TriangleMesh& mesh : setup.objects) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const Vec3d& p : widened(mesh.positions)) positions.push_back(p);
    for (mesh::Triangle t : mesh.triangles) triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  for (std::uint32_t p = 0; p < positions.size(); ++p) scenery.ids.push_back(kColliderPoint | p);
  auto next = static_cast<std::uint32_t>(kColliderPoint | positions.size());
  scenery.object = reference::features_of(std::move(positions), std::move(triangles));
  const auto rounded = [](const Vec3d& p) { return p.to<float>().to<double>(); };
  for (const scene::Collider& shape :
       setup.shapes) {  // each point is followed by its spin; of a plane the normal is between
    if (const auto* sphere = std::get_if<scene::ColliderSphere>(&shape)) {
      scenery.object.add_sphere(rounded(sphere->center), sphere->radius);
      scenery.ids.push_back(next);
    } else if (const auto* capsule = std::get_if<scene::ColliderCapsule>(&shape)) {
      scenery.object.add_capsule(rounded(capsule->a), rounded(capsule->b), capsule->radius);
      scenery.ids.push_back(next);
      scenery.ids.push_back(next += 2);
    } else if (const auto* plane = std::get_if<scene::ColliderPlane>(&shape)) {
      scenery.planes.push_back({rounded(plane->point), rounded(plane->normal)});
      scenery.plane_ids.push_back(next++);  // and that by its normal
    }
    next += 2;
  }
  return scenery;
}

/// A pair that a search may list, with the sets of its vertices.
struct PossiblePair {
  FeatureKey key{};
  MovingPair moving;
  double thickness = 0;  // [m]
  double doubt = 0;      // of its distance: how far f32 may have it otherwise [m]
};

/// All pairs nearer than the sets of any vertices and the thickness, and `beyond` [m]. The error of an f32 distance is
/// a few 2^-24 of the coordinates' differences, `band` [m]; edges that are parallel within 1e-3, which the kernel takes
/// as parallel, may be measured from an end and differ by that much of their length.
inline std::vector<PossiblePair> possible_pairs(const SearchFound& found, const SearchRun& run, double band,
                                                double beyond = 0) {
  using reference::PairKind;
  const SearchCase& setup = run.setup();
  const Scenery scenery = scenery_of(run);
  const auto& [cloth, object, ids, planes, plane_ids] = scenery;
  const double scripted = found.statistics.reach;
  double most = 0;
  for (std::size_t v = 0; v < found.places.size(); ++v)
    if (finite(found.places[v].xyz()))
      most = std::max(most, found.places[v].w + length(found.aheads[v].to<double>()));
  std::vector<reference::FeaturePair> pairs;
  if (setup.self_thickness > 0)
    pairs = reference::self_pairs(cloth, 1.01 * (setup.self_thickness + 2 * most) + beyond);
  const double radius = 1.01 * (setup.thickness + most + scripted) + beyond;
  for (const auto& p : reference::object_pairs(cloth, object, reference::trees_of(object), radius))
    pairs.push_back(p);
  for (const auto& p : reference::plane_pairs(cloth, planes, radius)) pairs.push_back(p);

  std::vector<PossiblePair> possible;
  for (const reference::FeaturePair& pair : pairs) {
    PossiblePair next;
    MovingPair& moving = next.moving;
    moving.kind = pair.kind;
    next.doubt = band;
    const bool self = pair.kind == PairKind::VertexTriangle || pair.kind == PairKind::EdgeEdge;
    next.thickness = self ? setup.self_thickness : setup.thickness;
    const auto of_cloth = [&](auto vertices) {
      std::vector<MotionSet> sets;
      for (const std::uint32_t v : vertices)
        sets.push_back({cloth.positions[v], found.places[v].w, found.aheads[v].to<double>()});
      return sets;
    };
    const auto of_object = [&](auto vertices) {
      std::vector<MotionSet> sets;
      for (const std::uint32_t v : vertices) sets.push_back({object.positions[v], scripted, {}});
      return sets;
    };
    const reference::Features& other = self ? cloth : object;
    const auto of_other = [&](auto vertices) { return self ? of_cloth(vertices) : of_object(vertices); };
    const auto id = [&](std::uint32_t v) { return self ? v : ids[v]; };
    if (pair.kind == PairKind::VertexPlane) {
      next.key = {2, pair.a, plane_ids[pair.b], 0, 0};
      moving.a = of_cloth(std::array{pair.a});
      moving.b = {{planes[pair.b].point, scripted, {}}};
      moving.normal = planes[pair.b].normal;
    } else if (pair.kind == PairKind::VertexBall || pair.kind == PairKind::VertexCapsule) {
      const bool capsule = pair.kind == PairKind::VertexCapsule;
      const mesh::Edge axis = capsule ? object.edges[pair.b] : mesh::Edge{pair.b, pair.b};
      next.key = {2, pair.a, ids[axis[0]], capsule ? ids[axis[1]] : 0, 0};
      moving.a = of_cloth(std::array{pair.a});
      moving.b = of_object(axis);
      moving.radius = object.radius_of_vertex(axis[0]);
    } else if (pair.kind == PairKind::EdgeEdge || pair.kind == PairKind::EdgeObjectEdge) {
      const mesh::Edge &a = cloth.edges[pair.a], &b = other.edges[pair.b];
      next.key = edge_key(a, {id(b[0]), id(b[1])});
      moving.a = of_cloth(a);
      moving.b = of_other(b);
      moving.radius = other.radius_of_edge(pair.b);
      const Vec3d u = moving.a[1].place - moving.a[0].place, v = moving.b[1].place - moving.b[0].place;
      const double sine = length(cross(u, v)) / (length(u) * length(v));
      if (sine > 0 && sine < 2e-3) next.doubt += sine * std::max(length(u), length(v));
    } else if (pair.kind == PairKind::ObjectVertexTriangle) {
      next.key = corner_key(ids[pair.a], cloth.triangles[pair.b]);
      moving.a = of_object(std::array{pair.a});
      moving.b = of_cloth(cloth.triangles[pair.b]);
      moving.radius = object.radius_of_vertex(pair.a);
    } else {
      const mesh::Triangle& face = other.triangles[pair.b];
      next.key = corner_key(pair.a, {id(face[0]), id(face[1]), id(face[2])});
      moving.a = of_cloth(std::array{pair.a});
      moving.b = of_other(face);
    }
    possible.push_back(next);
  }
  return possible;
}

struct PairCount {
  std::size_t sure = 0, doubtful = 0, found = 0;  // that the law lists, and that the search lists
  std::size_t beyond = 0;                         // that the law lists, but that boxes may leave out
  double nearest = std::numeric_limits<double>::infinity();  // gap, less what the law asks [m]
};

/// Adds what the law lists. An error of a distance turns n by itself over the distance.
inline void add_lawful(std::map<FeatureKey, PairCount>& counts, const std::vector<PossiblePair>& possible) {
  for (const PossiblePair& pair : possible) {
    const reference::Gap gap = gap_at(pair.moving, start_of(pair.moving));
    const Nearing may = nearing(pair.moving, gap.direction);
    const double beside = gap.distance - pair.thickness - may.slack, over = beside - may.ahead;
    const double apart = gap.distance + pair.moving.radius;  // of centre or axis
    const double turned = apart > pair.doubt ? pair.doubt / apart : 1;
    const double doubt = pair.doubt + (pair.moving.kind == reference::PairKind::VertexPlane ? 1e-6 : turned) *
                                          farthest_ahead(pair.moving);
    PairCount& count = counts[pair.key];
    count.nearest = std::min(count.nearest, over);
    const bool sure = over < -doubt || beside < -pair.doubt;
    if (sure && boxes_meet(pair.moving, pair.thickness - pair.doubt))
      ++count.sure;
    else if (over <= doubt && boxes_meet(pair.moving, pair.thickness + pair.doubt))
      ++count.doubtful;
    else if (over <= doubt)
      ++count.beyond;
  }
}

/// A triangle of cloth with a corner that is not finite lists no features that it owns.
class Sick {
 public:
  explicit Sick(const SearchRun& run) : run_(run) {
    for (const std::uint32_t t : run.search().order()) ordered_.push_back(run.setup().cloth.triangles[t]);
    const std::vector<std::uint32_t> owned = contact::feature_owners(ordered_);
    for (std::uint32_t t = 0; t < ordered_.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = ordered_[t][k], b = ordered_[t][(k + 1) % 3];
        if ((owned[t] >> k & 1U) != 0) owner_[{a, a}] = t;
        if ((owned[t] >> (3 + k) & 1U) != 0) owner_[{std::min(a, b), std::max(a, b)}] = t;
      }
  }
  /// Of features of cloth; those of an object that is not finite are for the test not to ask for.
  bool operator()(const FeatureKey& key) const {
    const auto owner_is = [&](const NumberPair& feature) {
      const auto at = owner_.find(feature);
      return at != owner_.end() && !box_of(run_.setup().cloth.positions, ordered_[at->second]).whole;
    };
    if (key[0] != 1) return owner_is({key[1], key[1]});
    return owner_is({key[1], key[2]}) || owner_is({key[3], key[4]});
  }

 private:
  const SearchRun& run_;
  std::vector<mesh::Triangle> ordered_;
  std::map<NumberPair, std::uint32_t> owner_;
};

/// The distance that a listed pair keeps is that of the law (contact_law.hpp) for its features at rest.
inline void check_thickness(const ListedPair& pair, const SearchRun& run, double band) {
  const SearchCase& setup = run.setup();
  const float thickness = thickness_of(pair);
  std::array<std::uint32_t, 4> v = pair.ids;
  const bool plane = (v[1] & kPairFlag) != 0, edges = !plane && (v[0] & kPairFlag) != 0;
  if (plane || ((v[0] | v[1] | v[2] | v[3]) & kColliderPoint) != 0) {
    CHECK(thickness == setup.thickness);
    return;
  }
  v[0] &= kIdBits;
  if (run.cloth_of(v[0]) != run.cloth_of(v[2])) {
    CHECK(thickness == setup.self_thickness);
    return;
  }
  const auto at = [&](std::size_t k) { return run.rest()[v[k]].to<double>(); };
  double apart = 0;
  if (edges) {
    apart = reference::closest_segments(at(0), at(1), at(2), at(3)).distance;
    const Vec3d a = at(1) - at(0), b = at(3) - at(2);
    const double sine = length(cross(a, b)) / (length(a) * length(b));
    if (sine > 0 && sine < 2e-3) band += sine * std::max(length(a), length(b));
  } else {
    apart = reference::closest_on_triangle(at(0), at(1), at(2), at(3)).distance;
  }
  const double touching = kTouchingAtRest * setup.self_thickness;
  const double expected = apart <= touching ? 0 : pair_thickness(setup.self_thickness, apart);
  const bool doubtful = std::abs(apart - touching) <= band;
  if (!(std::abs(thickness - expected) <= band || (doubtful && thickness == 0)))
    FAIL_CHECK("a pair of ", v[0], " ", v[1], " ", v[2], " ", v[3], ", ", apart, " m apart at rest, keeps ",
               thickness, " m, expected ", expected);
}

struct ListCheck {
  std::size_t pairs = 0, doubtful = 0;
};

/// The listed pairs are the law's, each as often as brute force finds it; `band` [m] as of possible_pairs.
inline ListCheck check_pairs(const SearchFound& found, const SearchRun& run, double band) {
  std::map<FeatureKey, PairCount> counts;
  add_lawful(counts, possible_pairs(found, run, band));
  ListCheck result;
  for (const ListedPair& pair : found.pairs) {
    if (is_crossing(pair)) continue;
    ++counts[key_of(pair.ids)].found;
    ++result.pairs;
    check_thickness(pair, run, band);
  }
  const Sick sick(run);
  std::size_t wrong = 0;
  for (const auto& [key, count] : counts) {
    result.doubtful += count.doubtful;
    if (count.found >= count.sure && count.found <= count.sure + count.doubtful + count.beyond) continue;
    if (count.found == 0 && sick(key)) continue;
    if (++wrong <= 5)
      FAIL_CHECK("kind ", key[0], " of ", key[1], " ", key[2], " ", key[3], " ", key[4], ": listed ",
                 count.found, " times, expected ", count.sure, " to ",
                 count.sure + count.doubtful + count.beyond, "; gap less what the law asks ", count.nearest,
                 " m");
  }
  CHECK(wrong == 0);
  CHECK(result.doubtful * 50 <= result.pairs + 500);
  return result;
}

}  // namespace weft
