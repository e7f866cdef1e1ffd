// The search's crossings of edges and triangles, against exact signs and the ways apart in
// double.
#include <map>
#include <set>

#include "contact/reference/proximity/audit.hpp"
#include "contact/reference/proximity/untangle.hpp"
#include "contact/search_checks.hpp"
#include "mesh/primitives.hpp"
#include "mesh/sheet_rim.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

/// An edge's two vertices, the lower first, and a triangle's three, sorted; ids as the search has them.
using CrossingKey = std::array<std::uint32_t, 5>;
CrossingKey crossing_key(std::uint32_t p, std::uint32_t q, std::array<std::uint32_t, 3> face) {
  std::sort(face.begin(), face.end());
  return {std::min(p, q), std::max(p, q), face[0], face[1], face[2]};
}

/// All cloth and all objects of a case as triangles of ids, with what untangling needs to know of them.
class Everything {
 public:
  explicit Everything(const SearchRun& run) {
    const SearchCase& setup = run.setup();
    std::vector<mesh::Triangle> ordered;
    for (const std::uint32_t t : run.search().order()) ordered.push_back(setup.cloth.triangles[t]);
    add(setup.cloth.positions, ordered, 0, SurfaceKind::Cloth);
    for (std::size_t o = 0; o < setup.objects.size(); ++o) {
      const mesh::TriangleMesh& mesh = setup.objects[o];
      const bool closed = faces_outward(widened(mesh.positions), mesh.triangles);
      add(mesh.positions, mesh.triangles, kColliderPoint | run.first_point(o),
          closed ? SurfaceKind::ClosedMesh : SurfaceKind::OpenMesh);
    }
  }
  const Vec3d& place(std::uint32_t id) const { return places_.at(id); }

  /// By exact signs, each edge once.
  std::set<CrossingKey> crossings() const {
    std::set<CrossingKey> found;
    for (const auto& own : triangles_)
      for (const auto& other : triangles_) {
        if (((own[0] & other[0]) & kColliderPoint) != 0) continue;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t p = own[k], q = own[(k + 1) % 3];
          if (std::any_of(other.begin(), other.end(), [&](std::uint32_t v) { return v == p || v == q; }))
            continue;
          if (segment_crosses(place(p), place(q), place(other[0]), place(other[1]), place(other[2])))
            found.insert(crossing_key(p, q, other));
        }
      }
    return found;
  }

  /// The ways apart by either triangle of the edge: which of them owns it depends on the tree.
  std::vector<Vec3d> ways(std::uint32_t p, std::uint32_t q, const std::array<std::uint32_t, 3>& face) const {
    std::vector<std::pair<std::array<std::uint32_t, 3>, std::size_t>> owners;
    for (const auto& t : triangles_)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
        if (std::minmax(a, b) == std::minmax(p, q)) owners.push_back({t, k});
      }
    std::vector<Vec3d> found;
    for (std::size_t i = 0; i < owners.size(); ++i) {
      std::optional<Vec3d> opposite;
      for (std::size_t j = 0; j < owners.size() && !opposite; ++j)
        if (j != i) opposite = place(owners[j].first[(owners[j].second + 2) % 3]);
      found.push_back(
          way_apart(crossing_face(owners[i].first), owners[i].second, opposite, crossing_face(face)));
    }
    return found;
  }

 private:
  void add(const std::vector<Vec3f>& positions, const std::vector<mesh::Triangle>& triangles,
           std::uint32_t first, SurfaceKind kind) {
    const std::vector<Vec3d> wide = widened(positions);
    for (std::uint32_t v = 0; v < wide.size(); ++v) {
      places_[first + v] = wide[v];
      kinds_[first + v] = kind;
    }
    for (mesh::Triangle t : triangles) triangles_.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  CrossingFace crossing_face(const std::array<std::uint32_t, 3>& ids) const {
    CrossingFace face;
    for (std::size_t k = 0; k < 3; ++k) {
      face.corners[k] = place(ids[k]);
      face.rims[k] = rims.at(ids[k]);
    }
    face.kind = kinds_.at(ids[0]);
    return face;
  }

  std::map<std::uint32_t, Vec3d> places_;
  std::map<std::uint32_t, SurfaceKind> kinds_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;

 public:
  std::map<std::uint32_t, double> rims;
};

/// Inputs of a search from its making: the rims are those of the places at rest.
std::map<std::uint32_t, double> rims_of(const SearchRun& run, const SearchCase& rest) {
  std::map<std::uint32_t, double> rims;
  const std::vector<double> cloth = rim_distances(widened(rest.cloth.positions), rest.cloth.triangles);
  for (std::uint32_t v = 0; v < cloth.size(); ++v) rims[v] = cloth[v];
  for (std::size_t o = 0; o < rest.objects.size(); ++o) {
    const std::vector<double> object =
        rim_distances(widened(rest.objects[o].positions), rest.objects[o].triangles);
    for (std::uint32_t v = 0; v < object.size(); ++v)
      rims[kColliderPoint | (run.first_point(o) + v)] = object[v];
  }
  return rims;
}

struct Compared {
  std::size_t crossings = 0, differing = 0, marked = 0;
  double worst = 0;  // of the ways
};

/// Every crossing is listed by both ends of its edge, once where the edge is an object's, and by no other.
Compared compare(SearchRun& run, const SearchCase& rest) {
  Everything all(run);
  all.rims = rims_of(run, rest);
  const SearchFound found = run.run();
  const std::set<CrossingKey> exact = all.crossings();
  std::map<CrossingKey, std::set<std::uint32_t>> listed;
  std::set<std::uint32_t> tangled;
  Compared result;
  for (const ListedPair& pair : found.pairs) {
    if (!is_crossing(pair)) continue;
    const std::uint32_t p = pair.ids[0], q = pair.words[0] | (p & kColliderPoint);
    const std::array<std::uint32_t, 3> face{pair.ids[1], pair.ids[2] & ~kCrossingFlag, pair.ids[3]};
    CHECK(listed[crossing_key(p, q, face)].insert(p).second);
    for (const std::uint32_t v : {p, q, face[0], face[1], face[2]})
      if ((v & kColliderPoint) == 0) tangled.insert(v);
    std::array<float, 3> numbers{};
    std::memcpy(numbers.data(), &pair.words[1], sizeof numbers);
    const Vec3d way = Vec3f{numbers[0], numbers[1], numbers[2]}.to<double>();
    double off = 3;
    for (const Vec3d& expected : all.ways(p, q, face)) off = std::min(off, length(way - expected));
    result.worst = std::max(result.worst, off < 1e-3 ? off : 0);
    // Where a sign or a choice between two ways is decided by rounding, the way is another one.
    if (!(off < 1e-3)) ++result.differing;
  }
  for (const auto& [key, ends] : listed) CHECK(ends.size() == ((key[0] & kColliderPoint) != 0 ? 1U : 2U));
  std::size_t missing = 0, stray = 0;
  for (const CrossingKey& key : exact) missing += listed.count(key) == 0 ? 1 : 0;
  for (const auto& [key, ends] : listed) stray += exact.count(key) == 0 ? 1 : 0;
  CHECK(stray == 0);
  CHECK(missing * 200 <= exact.size());  // what touches within rounding does not cross for f32
  CHECK(found.statistics.crossings_left == listed.size());
  for (std::uint32_t v = 0; v < run.setup().cloth.positions.size(); ++v) {
    const bool mark = (found.vertex_contacts[kVertexWords * v + kTangledWord]) != 0;
    CHECK(mark == (tangled.count(v) != 0));
    result.marked += mark ? 1 : 0;
  }
  result.crossings = listed.size();
  std::printf("%zu crossings of %zu, %zu vertices marked, ways within %.2g, %zu other\n", listed.size(),
              exact.size(), result.marked, result.worst, result.differing);
  return result;
}

SearchCase case_with_objects() {
  SearchCase made = sheet_of(257);
  mesh::TriangleMesh ball = mesh::make_sphere(10, 8);
  for (Vec3f& p : ball.positions) p = (0.2 * p.to<double>() + Vec3d{0.3, -0.05, 0.4}).to<float>();
  SearchCase plate = sheet_of(40);
  for (Vec3f& p : plate.cloth.positions) p = {0.05F + 0.9F * p.x, p.z - 0.4F, 0.11F + 0.1F * p.x};
  made.objects = {ball, plate.cloth};
  made.deforming = {false, true};
  return made;
}

}  // namespace

TEST_CASE("edges that pass through triangles are listed as exact signs say, with the ways apart of double") {
  GpuFixture fixture;
  const SearchCase rest = case_with_objects();
  SearchRun run(fixture.device(), rest);
  for (const Shape shape : kShapes) {
    CAPTURE(static_cast<int>(shape));
    run.place(shaped(rest.cloth.positions, shape, 5));
    const Compared with = compare(run, rest);
    CHECK(with.crossings > 10);
    CHECK(with.differing * 50 <= 2 * with.crossings + 100);
  }
}

TEST_CASE("a sheet that lies in its own way nowhere lists no crossing and marks no vertex") {
  GpuFixture fixture;
  SearchCase rest = sheet_of(200);
  SearchRun run(fixture.device(), rest);
  for (const Shape shape : {Shape::Flat, Shape::Wavy, Shape::Accordion}) {
    run.place(shaped(rest.cloth.positions, shape));
    const Compared with = compare(run, rest);
    CHECK(with.crossings == 0);
    CHECK(with.marked == 0);
  }
}
