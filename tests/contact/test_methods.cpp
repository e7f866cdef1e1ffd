// Both methods against each other, and both against double.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>

#include "contact/push_fixture.hpp"
#include "contact/reference/pushes/pairs.hpp"
#include "contact/reference/pushes/pushes.hpp"
#include "mesh/primitives.hpp"
#include "mesh/read_mesh.hpp"
#include "source_path.hpp"
#include "state/hash_pair.hpp"

using namespace weft;
using contact::PushSetup;
using scene::ContactMethod;

namespace {

struct PoseShape {
  double height, wave;  // of the object's height
};
constexpr PoseShape kShapes[] = {
    {0.9, 0.0}, {0.6, 0.02}, {0.4, 0.2}};  // lies on it, sags through it, is crumpled

mesh::TriangleMesh object_of(const std::string& name) {
  if (name == "sphere") return mesh::make_sphere(20, 20);
  auto mesh = mesh::read_mesh(source_path("models/" + name + ".ply"));
  REQUIRE_MESSAGE(mesh, mesh.error().message);
  mesh::drop_degenerate_triangles(*mesh);
  return *mesh;
}

PushSetup setup_of(ContactMethod method, const mesh::TriangleMesh& object, double thickness) {
  PushSetup setup;
  setup.method = method;
  setup.objects = {object};
  setup.thickness = thickness;
  return setup;
}

std::uint32_t hash_of(const std::vector<reference::TrianglePair>& pairs) {
  std::uint32_t hash = 0;
  for (const auto& pair : pairs) hash += hash_pair(pair.cloth, pair.object);
  return hash;
}

/// Whether the pairs found are the certain ones and some of the ambiguous ones, by count and hash.
bool explained(const Statistics& found, const reference::PairList& list) {
  REQUIRE(list.ambiguous.size() < 20);
  for (std::uint32_t some = 0; some < 1U << list.ambiguous.size(); ++some) {
    std::uint32_t hash = hash_of(list.hits);
    for (std::size_t i = 0; i < list.ambiguous.size(); ++i)
      if ((some >> i & 1U) != 0) hash += hash_pair(list.ambiguous[i].cloth, list.ambiguous[i].object);
    if (found.contact_hash == hash &&
        found.contacts == list.hits.size() + static_cast<std::size_t>(std::popcount(some)))
      return true;
  }
  return false;
}

/// Pushes against double; a node of an ambiguous pair may differ.
void check_pushes(const Pose& pose, const mesh::TriangleMesh& object, const Found& found,
                  const reference::PairList& list, double thickness) {
  std::vector<Vec3d> previous;
  std::vector<double> inverse_mass;
  double size = 0;
  for (const Vec4f& p : pose.previous) {
    previous.push_back(p.xyz().to<double>());
    inverse_mass.push_back(p.w);
    size = std::max(
        {size, std::abs(previous.back().x), std::abs(previous.back().y), std::abs(previous.back().z)});
  }
  const auto expected = reference::pushes_of(list.hits, pose.triangles, previous, inverse_mass, object,
                                             {thickness, found.max_push});
  std::vector<bool> doubtful(previous.size(), false);
  for (const auto& pair : list.ambiguous)
    for (const std::uint32_t node : pose.triangles[pair.cloth]) doubtful[node] = true;
  for (std::size_t node = 0; node < previous.size(); ++node) {
    if (doubtful[node]) continue;
    CAPTURE(node);
    REQUIRE(static_cast<std::uint32_t>(found.pushes[4 * node + 3]) == expected[node].count);
    // Each push is rounded to half a unit; its distance carries a few roundings of the coordinates (2^-24
    // each).
    const double tolerance = expected[node].count * (0.5 / found.push_scale + 8 * size / (1U << 24U));
    for (int axis = 0; axis < 3; ++axis) {
      const double sum =
          found.pushes[4 * node + static_cast<std::size_t>(axis)] / static_cast<double>(found.push_scale);
      CHECK(std::abs(sum - expected[node].sum[axis]) <= tolerance);
    }
  }
}

/// One object, three poses: paper, bvh and double.
void check_object(const std::string& name, std::uint32_t nodes) {
  GpuFixture fixture;
  const mesh::TriangleMesh object = object_of(name);
  const mesh::Bounds box = mesh::bounds(object);
  const double thickness = 0.01 * static_cast<double>(length(box.high - box.low));
  const Pose rest = sheet_over(box, nodes, 1, 0, 7);
  PushRun paper_run(fixture.device(), rest, setup_of(ContactMethod::Paper, object, thickness));
  PushRun bvh_run(fixture.device(), rest, setup_of(ContactMethod::Bvh, object, thickness));
  for (const PoseShape& shape : kShapes) {
    const Pose pose = sheet_over(box, nodes, shape.height, shape.wave, 7);
    paper_run.place(pose);
    bvh_run.place(pose);
    const Found paper = paper_run.run(), bvh = bvh_run.run();
    CHECK(paper.same_as(bvh));
    CHECK(bvh.statistics.contact_overflow == 0);
    CHECK(bvh.statistics.contacts > 30);
    const reference::PairList list = reference::find_pairs(pose.predicted_mesh(), object);
    std::printf("%s, %zu x %zu triangles: %u hits, %zu ambiguous of %llu candidates\n", name.c_str(),
                pose.triangles.size(), object.triangles.size(), bvh.statistics.contacts,
                list.ambiguous.size(), static_cast<unsigned long long>(list.candidates));
    CHECK(explained(bvh.statistics, list));
    check_pushes(pose, object, bvh, list, thickness);
  }
}

}  // namespace

TEST_CASE("paper and bvh find the pairs of double and push by the same bits: sphere") {
  check_object("sphere", 41);
}
TEST_CASE("paper and bvh find the pairs of double and push by the same bits: armadillo") {
  check_object("armadillo", 14);
}
TEST_CASE("paper and bvh find the pairs of double and push by the same bits: dragon") {
  check_object("dragon", 10);
}
TEST_CASE("long: paper and bvh find the pairs of double and push by the same bits: larger sheets") {
  check_object("armadillo", 40);
  check_object("dragon", 30);
}

TEST_CASE("no bit depends on the workgroup, on the run, on the split, or on the parity of the substep") {
  GpuFixture fixture;
  const mesh::TriangleMesh object = mesh::make_sphere(40, 40);
  const Pose pose = sheet_over(mesh::bounds(object), 22, 0.6, 0.05, 3);
  for (const ContactMethod method : {ContactMethod::Paper, ContactMethod::Bvh}) {
    PushSetup setup = setup_of(method, object, 0.02);
    setup.spheres = {{{0, 0, 0}, 0.5}};
    const Found first = find_contacts(fixture.device(), pose, setup);
    REQUIRE(first.statistics.contacts > 100);
    PushRun again(fixture.device(), pose, setup);
    for (int i = 0; i < 5; ++i) CHECK(again.run().same_as(first));
    for (const std::uint32_t workgroup : {64U, 128U}) {
      setup.workgroup_size = workgroup;
      CHECK(find_contacts(fixture.device(), pose, setup).same_as(first));
    }
    CHECK(find_contacts(fixture.device(), pose, setup, 1).same_as(first));
    for (const std::uint32_t each : {1U, 2U}) {
      setup.triangles_each = each;
      CHECK(find_contacts(fixture.device(), pose, setup).same_as(first));
    }
    for (const std::uint64_t pairs : {1ULL, 100000ULL, 1000000ULL}) {  // 1: an object triangle a dispatch
      if (pairs == 1 && method == ContactMethod::Bvh) continue;
      setup.max_pairs = pairs;
      const Found split = find_contacts(fixture.device(), pose, setup);
      CHECK(split.same_as(first));
      const std::uint64_t most = std::max<std::uint64_t>(pairs / pose.triangles.size(), 1);
      const std::size_t expected = (object.triangles.size() + most - 1) / most;
      CHECK(split.dispatches == (method == ContactMethod::Paper ? expected : 1) + 1);
    }
  }
}

TEST_CASE("the last of an odd number of cloth triangles counts once") {
  GpuFixture fixture;
  const mesh::TriangleMesh object = mesh::make_sphere(20, 20);
  Pose pose = sheet_over(mesh::bounds(object), 12, 0.7, 0.02, 13);
  const reference::PairList whole = reference::find_pairs(pose.predicted_mesh(), object);
  const auto even = std::find_if(whole.hits.begin(), whole.hits.end(),
                                 [](const reference::TrianglePair& pair) { return pair.cloth % 2 == 0; });
  REQUIRE(even != whole.hits.end());
  pose.triangles.resize(even->cloth + 1);
  const reference::PairList list = reference::find_pairs(pose.predicted_mesh(), object);
  for (const ContactMethod method : {ContactMethod::Paper, ContactMethod::Bvh})
    for (const std::uint32_t each : {1U, 2U}) {
      PushSetup setup = setup_of(method, object, 0.02);
      setup.triangles_each = each;
      CHECK(explained(find_contacts(fixture.device(), pose, setup).statistics, list));
    }
}

TEST_CASE("several objects are one list: hits and pushes are those of the joined mesh") {
  GpuFixture fixture;
  mesh::TriangleMesh left = mesh::make_sphere(20, 20), right = left, joined = left;
  for (Vec3f& p : right.positions) p.x += 1.5F;
  const auto first = static_cast<std::uint32_t>(joined.positions.size());
  joined.positions.insert(joined.positions.end(), right.positions.begin(), right.positions.end());
  for (const mesh::Triangle& t : right.triangles)
    joined.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  const Pose pose = sheet_over(mesh::bounds(joined), 25, 0.7, 0.02, 5);
  for (const ContactMethod method : {ContactMethod::Paper, ContactMethod::Bvh}) {
    PushSetup apart = setup_of(method, left, 0.02);
    apart.objects.push_back(right);
    const Found found = find_contacts(fixture.device(), pose, apart);
    CHECK(found.same_as(find_contacts(fixture.device(), pose, setup_of(method, joined, 0.02))));
    CHECK(found.statistics.contacts > 50);
  }
}

TEST_CASE("at large offsets and odd scales the pairs are those of double") {
  GpuFixture fixture;
  struct Place {
    double scale;
    Vec3d offset;
  };
  for (const Place& place : {Place{1e-4, {}}, Place{1e4, {}}, Place{50, {1e5, -1e5, 1e5}}}) {
    CAPTURE(place.scale);
    const mesh::TriangleMesh object =
        mesh::transformed(mesh::make_sphere(20, 20), place.scale, {0, 0, 0, 1}, place.offset);
    const Pose pose = sheet_over(mesh::bounds(object), 20, 0.7, 0.02, 11);
    const reference::PairList list = reference::find_pairs(pose.predicted_mesh(), object);
    const Found paper =
        find_contacts(fixture.device(), pose, setup_of(ContactMethod::Paper, object, 0.01 * place.scale));
    const Found bvh =
        find_contacts(fixture.device(), pose, setup_of(ContactMethod::Bvh, object, 0.01 * place.scale));
    CHECK(paper.same_as(bvh));
    CHECK(bvh.statistics.contacts > 50);
    CHECK(explained(bvh.statistics, list));
    check_pushes(pose, object, bvh, list, 0.01 * place.scale);
  }
}
