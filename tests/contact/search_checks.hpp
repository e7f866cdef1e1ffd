// The expected result of a search, and checks of the real one: triangles by their boxes in the kernel's arithmetic,
// features by the reference in double.
#pragma once

#include <cmath>
#include <cstdio>
#include <limits>

#include "contact/proximity/feature_owners.hpp"
#include "contact/reference/proximity/pairs.hpp"
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

/// The largest of the vertices' [m].
template <class Vertices>
float reach_of(const std::vector<float>& reaches, const Vertices& vertices) {
  float most = 0;
  for (const std::uint32_t v : vertices) most = std::max(most, reaches[v]);
  return most;
}
/// Whether flat cloth may be left out between two features.
inline bool slow(const SearchCase& setup, float reach_a, float reach_b) {
  return reach_a + reach_b <= 2 * setup.reach;
}

enum class Flat { No, Yes, Doubtful };
/// The kernel's lie_flat in double; doubtful where f32 may see it otherwise.
inline Flat lie_flat(const std::vector<Vec3f>& positions, const mesh::Triangle& x, const mesh::Triangle& y) {
  Vec3d middle, all_x, all_y;
  int shared = 0;
  for (const std::uint32_t v : x) {
    all_x += positions[v].to<double>();
    if (std::find(y.begin(), y.end(), v) == y.end()) continue;
    ++shared;
    middle += 0.5 * positions[v].to<double>();
  }
  for (const std::uint32_t v : y) all_y += positions[v].to<double>();
  if (shared != 2) return Flat::No;
  const Vec3d u = all_x - 3.0 * middle, v = all_y - 3.0 * middle;
  const double along = dot(u, v), sizes = dot(u, u) * dot(v, v);
  // u and v are sums of a few coordinates below 1 m, rounded to 2^-24 each.
  const double doubt = 4e-6 * (std::sqrt(sizes) + dot(u, u) + dot(v, v)) + 1e-12;
  if (std::abs(along) + 0.0 < doubt || std::abs(std::abs(along) - 0.25 * std::sqrt(sizes)) < doubt)
    return along > doubt ? Flat::No : Flat::Doubtful;
  return along < 0 && along * along > 0.0625 * sizes ? Flat::Yes : Flat::No;
}

/// Candidates as numbers of triangles in their meshes; of cloth with itself the lower first.
struct NamedCandidates {
  std::vector<NumberPair> self;
  std::vector<std::vector<NumberPair>> objects;  // cloth triangle, object triangle; for each object
  std::size_t shapes = 0;                        // with spheres, capsules, planes
  std::vector<float> reaches;                    // of the cloth's vertices [m]
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
  names.reaches = found.reaches;
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

/// The cloth's candidates are those of brute force, but for neighbours of which f32 may not know whether they
/// lie flat; gives their number.
inline std::size_t check_self_candidates(const NamedCandidates& names, const SearchRun& run) {
  const SearchCase& setup = run.setup();
  const std::vector<std::uint32_t>& order = run.search().order();
  std::vector<NumberPair> expected, doubtful;
  std::vector<BoxF> boxes;
  std::vector<float> reach;
  for (const std::uint32_t t : order) {
    boxes.push_back(box_of(setup.cloth.positions, setup.cloth.triangles[t]));
    reach.push_back(reach_of(names.reaches, setup.cloth.triangles[t]));
  }
  for (std::uint32_t i = 0; setup.self_thickness > 0 && i < order.size(); ++i)
    for (std::uint32_t j = i + 1; j < order.size(); ++j) {
      if (!boxes_meet(boxes[i], boxes[j], setup.self_thickness + reach[i], reach[j])) continue;
      Flat flat = Flat::No;
      if (slow(setup, reach[i], reach[j]))
        flat =
            lie_flat(setup.cloth.positions, setup.cloth.triangles[order[i]], setup.cloth.triangles[order[j]]);
      const NumberPair pair{std::min(order[i], order[j]), std::max(order[i], order[j])};
      if (flat == Flat::No) expected.push_back(pair);
      if (flat == Flat::Doubtful) doubtful.push_back(pair);
    }
  std::sort(doubtful.begin(), doubtful.end());
  for (const NumberPair& pair : doubtful)
    if (std::binary_search(names.self.begin(), names.self.end(), pair)) expected.push_back(pair);
  std::sort(expected.begin(), expected.end());
  CHECK(doubtful.size() * 100 <= expected.size() + 100);
  check_same(names.self, expected);
  return expected.size();
}

/// The candidates with an object whose points stand where the mesh has them; gives their number.
inline std::size_t check_object_candidates(const NamedCandidates& names, const SearchRun& run,
                                           std::size_t object) {
  const SearchCase& setup = run.setup();
  const mesh::TriangleMesh& mesh = setup.objects[object];
  std::vector<NumberPair> expected;
  for (std::uint32_t i = 0; i < setup.cloth.triangles.size(); ++i)
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      if (boxes_meet(box_of(setup.cloth.positions, setup.cloth.triangles[i]),
                     box_of(mesh.positions, mesh.triangles[t]),
                     setup.thickness + reach_of(names.reaches, setup.cloth.triangles[i])))
        expected.push_back({i, t});
  check_same(names.objects[object], expected);
  return expected.size();
}

/// A pair of features by its kind and vertices, whichever way round they were named.
using FeatureKey = std::array<std::uint32_t, 5>;

inline bool is_crossing(const Contact& contact) { return (contact.ids[2] & kCrossingFlag) != 0; }

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
  if ((ids[1] & kPairFlag) != 0) return {2, ids[0], ids[1] & ~kPairFlag, 0, 0};
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
  for (const scene::Collider& shape : setup.shapes) {  // each point is followed by its spin
    if (const auto* sphere = std::get_if<scene::ColliderSphere>(&shape)) {
      scenery.object.add_sphere(rounded(sphere->center), sphere->radius);
      scenery.ids.push_back(next);
    } else if (const auto* capsule = std::get_if<scene::ColliderCapsule>(&shape)) {
      scenery.object.add_capsule(rounded(capsule->a), rounded(capsule->b), capsule->radius);
      scenery.ids.push_back(next);
      scenery.ids.push_back(next += 2);
    } else if (const auto* plane = std::get_if<scene::ColliderPlane>(&shape)) {
      scenery.planes.push_back({rounded(plane->point), rounded(plane->normal)});
      scenery.plane_ids.push_back(next);
    }
    next += 2;
  }
  return scenery;
}

struct PairCount {
  std::size_t sure = 0, doubtful = 0, found = 0;  // that the reference finds, and that the search lists
  double nearest = std::numeric_limits<double>::infinity();  // gap, less the radius [m]
};

/// Adds what the reference finds. The error of an f32 distance is a few 2^-24 of the coordinates'
/// differences, `band` [m]; edges that are parallel within 1e-3, which the kernel takes as parallel, may be
/// measured from an end and differ by that much of their length.
inline void add_reference(std::map<FeatureKey, PairCount>& counts, const Scenery& scenery,
                          const SearchCase& setup, const std::vector<float>& reaches, double band) {
  using reference::PairKind;
  const auto& [cloth, object, ids, planes, plane_ids] = scenery;
  const double most = *std::max_element(reaches.begin(), reaches.end());
  const double self_radius = 1.01 * (setup.self_thickness + 2 * most),
               radius = 1.01 * (setup.thickness + most);
  std::vector<reference::FeaturePair> pairs;
  if (setup.self_thickness > 0) pairs = reference::self_pairs(cloth, self_radius);
  for (const auto& p : reference::object_pairs(cloth, object, reference::trees_of(object), radius))
    pairs.push_back(p);
  for (const auto& p : reference::plane_pairs(cloth, planes, radius)) pairs.push_back(p);
  for (const reference::FeaturePair& pair : pairs) {
    FeatureKey key{};
    double doubt = band;
    const bool self = pair.kind == PairKind::VertexTriangle || pair.kind == PairKind::EdgeEdge;
    const reference::Features& other = self ? cloth : object;
    const auto id = [&](std::uint32_t v) { return self ? v : ids[v]; };
    double reach = 0;  // of the cloth's side, or both
    const auto add_reach = [&](const auto& vertices) { reach += reach_of(reaches, vertices); };
    if (pair.kind == PairKind::VertexPlane) {
      key = {2, pair.a, plane_ids[pair.b], 0, 0};
      add_reach(std::array{pair.a});
    } else if (pair.kind == PairKind::EdgeEdge || pair.kind == PairKind::EdgeObjectEdge) {
      const mesh::Edge &a = cloth.edges[pair.a], &b = other.edges[pair.b];
      key = edge_key(a, {id(b[0]), id(b[1])});
      add_reach(a);
      if (self) add_reach(b);
      const Vec3d u = cloth.positions[a[1]] - cloth.positions[a[0]],
                  v = other.positions[b[1]] - other.positions[b[0]];
      const double sine = length(cross(u, v)) / (length(u) * length(v));
      if (sine > 0 && sine < 2e-3) doubt += sine * std::max(length(u), length(v));
    } else if (pair.kind == PairKind::ObjectVertexTriangle) {
      key = corner_key(ids[pair.a], cloth.triangles[pair.b]);
      add_reach(cloth.triangles[pair.b]);
    } else {
      const mesh::Triangle& face = other.triangles[pair.b];
      key = corner_key(pair.a, {id(face[0]), id(face[1]), id(face[2])});
      add_reach(std::array{pair.a});
      if (self) add_reach(face);
    }
    const double over = pair.distance - (self ? setup.self_thickness : setup.thickness) - reach;
    PairCount& count = counts[key];
    count.nearest = std::min(count.nearest, over);
    if (over < -doubt)
      ++count.sure;
    else if (over <= doubt)
      ++count.doubtful;
  }
}

/// Why the broad phase may leave a pair out: the triangles that own its features are neighbours that lie
/// flat, or one of them has a corner that is not finite and lists nothing.
class LeftOut {
 public:
  LeftOut(const SearchRun& run, const std::vector<float>& reaches) : run_(run), reaches_(reaches) {
    for (const std::uint32_t t : run.search().order()) ordered_.push_back(run.setup().cloth.triangles[t]);
    const std::vector<std::uint32_t> owned = contact::feature_owners(ordered_);
    for (std::uint32_t t = 0; t < ordered_.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = ordered_[t][k], b = ordered_[t][(k + 1) % 3];
        if ((owned[t] >> k & 1U) != 0) owner_[{a, a}] = t;
        if ((owned[t] >> (3 + k) & 1U) != 0) owner_[{std::min(a, b), std::max(a, b)}] = t;
      }
  }
  bool explain(const FeatureKey& key) const {
    if (sick(key)) return true;
    for (const std::uint32_t id : key)
      if ((id & kColliderPoint) != 0) return false;
    if (key[0] == 1) return flat(owner_.at({key[1], key[2]}), owner_.at({key[3], key[4]}));
    for (std::uint32_t t = 0; t < ordered_.size(); ++t)
      if (corner_key(key[1], ordered_[t]) == key && flat(owner_.at({key[1], key[1]}), t)) return true;
    return false;
  }

 private:
  bool flat(std::uint32_t x, std::uint32_t y) const {
    return slow(run_.setup(), reach_of(reaches_, ordered_[x]), reach_of(reaches_, ordered_[y])) &&
           lie_flat(run_.setup().cloth.positions, ordered_[x], ordered_[y]) != Flat::No;
  }
  /// Of features of cloth; those of an object that is not finite are for the test not to ask for.
  bool sick(const FeatureKey& key) const {
    const auto owner_is = [&](const NumberPair& feature) {
      const auto at = owner_.find(feature);
      return at != owner_.end() && !box_of(run_.setup().cloth.positions, ordered_[at->second]).whole;
    };
    if (key[0] != 1) return owner_is({key[1], key[1]});
    return owner_is({key[1], key[2]}) || owner_is({key[3], key[4]});
  }
  const SearchRun& run_;
  const std::vector<float>& reaches_;
  std::vector<mesh::Triangle> ordered_;
  std::map<NumberPair, std::uint32_t> owner_;
};

struct ListCheck {
  std::size_t pairs = 0, doubtful = 0, left_out = 0;  // the last: see LeftOut
};

/// The listed pairs are the reference's, each as often as it finds it; `band` [m] as of add_reference.
inline ListCheck check_contacts(const SearchFound& found, const SearchRun& run, double band) {
  const Scenery scenery = scenery_of(run);
  std::map<FeatureKey, PairCount> counts;
  add_reference(counts, scenery, run.setup(), found.reaches, band);
  ListCheck result;
  for (const Contact& contact : found.contacts) {
    if (is_crossing(contact)) continue;
    ++counts[key_of(contact.ids)].found;
    ++result.pairs;
  }
  const LeftOut left_out(run, found.reaches);
  std::size_t wrong = 0;
  for (const auto& [key, count] : counts) {
    result.doubtful += count.doubtful;
    if (count.found >= count.sure && count.found <= count.sure + count.doubtful) continue;
    if (count.found == 0 && left_out.explain(key)) {
      ++result.left_out;
      continue;
    }
    if (++wrong <= 5)
      FAIL_CHECK("kind ", key[0], " of ", key[1], " ", key[2], " ", key[3], " ", key[4], ": listed ",
                 count.found, " times, expected ", count.sure, " to ", count.sure + count.doubtful,
                 "; gap less radius ", count.nearest, " m");
  }
  CHECK(wrong == 0);
  return result;
}

/// Each cloth vertex's entries are the pairs that it is in, and the pairs know where they stand.
inline void check_entries(const SearchFound& found) {
  std::size_t roles = 0, wrong = 0;
  std::vector<bool> seen(found.entries.size());
  for (std::uint32_t pair = 0; pair < found.contacts.size(); ++pair) {
    const Contact& contact = found.contacts[pair];
    const std::uint32_t count = (contact.ids[1] & kPairFlag) != 0 ? 2 : 4;
    for (std::uint32_t role = 0; role < count; ++role) {
      if ((contact.ids[role] & kColliderPoint) != 0) continue;
      ++roles;
      const std::uint32_t slot = contact.slots[role], word = kVertexWords * (contact.ids[role] & kIdBits);
      REQUIRE(slot < found.entries.size());
      const std::uint32_t first = found.vertex_contacts[word], number = found.vertex_contacts[word + 1];
      if (seen[slot] || found.entries[slot] != 8 * pair + role || slot < first || slot >= first + number)
        ++wrong;
      seen[slot] = true;
    }
  }
  CHECK(wrong == 0);
  CHECK(roles == found.entries.size());
  std::size_t counted = 0;
  for (std::size_t word = 0; word < found.vertex_contacts.size(); word += kVertexWords) {
    counted += found.vertex_contacts[word + 1];
    if (found.vertex_contacts[word + 1] != (found.vertex_contacts[word + kCursorWord] & kCursorBits)) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(counted == found.entries.size());
}

/// Broad phase, narrow phase and entries of the case as it stands.
inline ListCheck check_all(SearchRun& run, double band = 0) {
  const SearchFound found = run.run();
  const NamedCandidates names = named(found, run);
  check_self_candidates(names, run);
  for (std::size_t o = 0; o < run.setup().objects.size(); ++o) check_object_candidates(names, run, o);
  const ListCheck checked = check_contacts(found, run, band > 0 ? band : 1e-5 * run.setup().self_radius());
  check_entries(found);
  return checked;
}

}  // namespace weft
