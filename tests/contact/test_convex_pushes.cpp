// Convex bodies on the GPU: the distance by GJK, and the pushes.
#include <algorithm>
#include <cmath>

#include "contact/convex_pairs.hpp"
#include "contact/push_fixture.hpp"
#include "contact/pushes/colliders_convex.hpp"
#include "contact/reference/pushes/convex_pushes.hpp"
#include "gpu/kernel.hpp"
#include "state/hash_pair.hpp"

using namespace weft;
using contact::PushSetup;

namespace {

constexpr double kUnit = 0x1p-24;

/// Results of contact/test/gjk_pairs.wgsl, three words a pair.
std::vector<Vec4f> run_gjk(gpu::Device& device, const std::vector<mesh::TriangleMesh>& hulls,
                           const std::vector<Vec4f>& corners) {
  const auto data = contact::convex_bodies(hulls);
  REQUIRE_MESSAGE(data, data.error().message);
  auto kernel = gpu::Kernel::create(device, "contact/test/gjk_pairs.wgsl");
  REQUIRE_MESSAGE(kernel, kernel.error().message);
  auto input = gpu::Buffer<Vec4f>::create_from(device, corners, "corners");
  auto bodies = gpu::Buffer<contact::ConvexBody>::create_from(device, data->bodies, "bodies");
  auto places = gpu::Buffer<Vec4f>::create_from(device, data->places, "places");
  auto words = gpu::Buffer<std::uint32_t>::create_from(device, data->words, "words");
  auto output = gpu::Buffer<Vec4f>::create(device, corners.size(), "results");
  REQUIRE((input && bodies && places && words && output));
  auto group = kernel->bind({*input, *bodies, *places, *words, *output});
  REQUIRE_MESSAGE(group, group.error().message);
  gpu::CommandList list;
  {
    gpu::ComputePass pass(list, "gjk");
    kernel->dispatch(pass, *group, corners.size() / 3);
  }
  REQUIRE(device.submit(list));
  auto results = gpu::download(device, *output);
  REQUIRE(results);
  return *results;
}

/// A sheet that hangs through the bodies, and has moved a little. No two of its nodes are at the same depth.
Pose waving_sheet(std::uint32_t n, std::uint64_t seed) {
  Pose pose = sheet_over({{-1, -1, -1}, {1, 1, 1}}, n, 0.6, 0.2, seed);
  Random random(seed + 1);
  for (std::size_t i = 0; i < pose.previous.size(); ++i) {
    const Vec3f shift = (0.01 * random_point(random)).to<float>();
    for (Vec4f* p : {&pose.previous[i], &pose.predicted[i]})
      *p = {p->x + shift.x, p->y + shift.y, p->z + shift.z, p->w};
  }
  for (std::size_t i = 0; i < pose.previous.size(); i += 7) pose.previous[i].w = pose.predicted[i].w = 0;
  return pose;
}

std::vector<mesh::TriangleMesh> two_bodies() {
  Random random(5);
  return {random_hull(random, 60, {0.7, 0.4, 0.6}), hull_of(mesh::make_box({1, 0.5, 0.7}).positions)};
}

}  // namespace

TEST_CASE("the kernel's distance of triangles and convex bodies is that of brute force in double") {
  GpuFixture fixture;
  const std::vector<mesh::TriangleMesh> hulls = convex_bodies(2, 500);
  const std::vector<reference::ConvexBody> bodies(hulls.begin(), hulls.end());
  Random random(8);
  constexpr std::size_t kEach = 3500;
  std::vector<Vec4f> corners;
  std::vector<CornersOfTriangle> triangles;
  for (int sort = 0; sort < kTriangleSorts; ++sort)
    for (std::size_t k = 0; k < kEach; ++k) {
      const std::size_t body = k % hulls.size();
      triangles.push_back(random_triangle(random, hulls[body], static_cast<TriangleSort>(sort)));
      for (const Vec3f& p : triangles.back()) corners.push_back(Vec4f::from(p, static_cast<float>(body)));
    }
  const std::vector<Vec4f> results = run_gjk(fixture.device(), hulls, corners);
  for (int sort = 0; sort < kTriangleSorts; ++sort) {
    std::size_t wrong = 0, loose = 0;
    double worst = 0, iterations = 0, most = 0, by_features = 0;
    for (std::size_t k = 0; k < kEach; ++k) {
      const std::size_t pair = static_cast<std::size_t>(sort) * kEach + k;
      const reference::ConvexBody& body = bodies[k % hulls.size()];
      const reference::TrianglePoints triangle = points_of(triangles[pair]);
      const reference::ConvexContact exact = reference::contact_by_features(triangle, body);
      const double size = reference::pair_size(triangle, body);
      const Vec4f weights = results[3 * pair], normal = results[3 * pair + 1], point = results[3 * pair + 2];
      const double error = std::abs(static_cast<double>(weights.w) - exact.distance) / (size * kUnit);
      // As in double (test_convex_distance.cpp), with the unit of f32; GJK's bounds are at most 48 apart.
      if (!(error <= 64)) {
        ++wrong;
        if (wrong <= 3)
          MESSAGE("pair " << pair << ": " << weights.w << ", not " << exact.distance << ", of size " << size);
      }
      worst = std::max(worst, error);
      iterations += static_cast<double>(normal.w);
      most = std::max(most, static_cast<double>(normal.w));
      by_features += static_cast<double>(point.w);
      const Vec3d p = static_cast<double>(weights.x) * triangle.a +
                      static_cast<double>(weights.y) * triangle.b +
                      static_cast<double>(weights.z) * triangle.c;
      const Vec3d n = normal.xyz().to<double>();
      const Vec3d off = p - point.xyz().to<double>() - static_cast<double>(weights.w) * n;
      const bool unit = std::abs(length(n) - 1) < 1e-6;
      // Touching pairs have a direction that separates them, within kTouch of gjk.wgsl, 2^-10.
      loose += unit && length(off) <= 0x1p-8 * size ? 0 : 1;
    }
    CAPTURE(sort);
    CHECK(wrong == 0);
    CHECK(loose == 0);
    CHECK(most < 64);  // so no search was given up
    CHECK(by_features <= kEach / 50.0);
    MESSAGE(sort << ": error " << worst << ", iterations " << iterations / kEach << " (most " << most
                 << "), by features " << by_features);
  }
}

TEST_CASE(
    "pushes at convex bodies are those of double, by paper and by bvh and of every workgroup size the same") {
  GpuFixture fixture;
  const Pose pose = waving_sheet(41, 2);
  PushSetup setup;
  setup.thickness = 0.0625;
  setup.hulls = two_bodies();
  setup.method = scene::ContactMethod::Bvh;
  const Found found = find_contacts(fixture.device(), pose, setup);
  setup.method = scene::ContactMethod::Paper;
  for (const std::uint32_t size : {64U, 128U, 256U}) {
    setup.workgroup_size = size;
    CHECK(find_contacts(fixture.device(), pose, setup).same_as(found));
  }

  const std::vector<reference::ConvexBody> bodies(setup.hulls.begin(), setup.hulls.end());
  std::vector<Vec3d> previous, predicted;
  std::vector<double> inverse_mass;
  for (std::size_t i = 0; i < pose.previous.size(); ++i) {
    previous.push_back(pose.previous[i].xyz().to<double>());
    predicted.push_back(pose.predicted[i].xyz().to<double>());
    inverse_mass.push_back(pose.previous[i].w);
  }
  std::vector<reference::NodePush> expected(previous.size());
  const reference::PushLimits limits{setup.thickness, found.max_push};
  const std::size_t contacts = reference::add_convex_pushes(expected, bodies, pose.triangles, previous,
                                                            predicted, inverse_mass, limits);
  // The nearest point of a triangle may be one of many, so where two are as near a node may be pushed by one of them
  // only: what differs is rare.
  CHECK(std::abs(static_cast<double>(found.statistics.contacts) - static_cast<double>(contacts)) <= 2);
  CHECK(contacts > 500);
  std::size_t differ = 0, pushed = 0;
  for (std::size_t node = 0; node < expected.size(); ++node) {
    bool same = static_cast<std::uint32_t>(found.pushes[4 * node + 3]) == expected[node].count;
    pushed += expected[node].count > 0 ? 1 : 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double sum =
          found.pushes[4 * node + static_cast<std::size_t>(axis)] / static_cast<double>(found.push_scale);
      same = same && std::abs(sum - expected[node].sum[axis]) <= expected[node].count * 2e-4;
    }
    differ += same ? 0 : 1;
    if (inverse_mass[node] == 0) CHECK(found.pushes[4 * node + 3] == 0);
  }
  CHECK(differ <= pushed / 100);
}

TEST_CASE("hulls that are not closed, or have a triangle without area, are refused") {
  mesh::TriangleMesh open = mesh::make_box({1, 1, 1});
  open.triangles.pop_back();
  const auto not_closed = contact::convex_bodies(std::span(&open, 1));
  REQUIRE_FALSE(not_closed);
  CHECK(not_closed.error().message.find("Convex hull 0 is not closed between its points") == 0);
  mesh::TriangleMesh flat = mesh::make_box({1, 1, 1});
  flat.positions[7] = flat.positions[6] = flat.positions[5] = flat.positions[4];
  const auto without_area = contact::convex_bodies(std::span(&flat, 1));
  REQUIRE_FALSE(without_area);
  CHECK(without_area.error().message.find("of convex hull 0 has no area") != std::string::npos);
}

TEST_CASE(
    "a single triangle's point goes to the thickness, by pushes along the normal in parts of its weights") {
  GpuFixture fixture;
  PushSetup setup;
  setup.thickness = 0.25;
  setup.hulls = {hull_of(mesh::make_box({2, 2, 2}).positions)};
  // Over the face at y = 1 only a point of the edge from node 0 to node 1 is near: a corner of the box is far.
  Pose pose;
  pose.triangles = {{0, 1, 2}};
  pose.predicted = {{0, 1.125F, 0, 1}, {0.5F, 1.5F, 0, 1}, {-0.5F, 1.5F, 0.5F, 1}};
  pose.previous = {{0, 1.0625F, 0, 1}, {0.5F, 1.5F, 0, 1}, {-0.5F, 1.5F, 0.5F, 1}};
  const Found corner = find_contacts(fixture.device(), pose, setup);
  const auto metres = [&](const Found& found, std::size_t word) {
    return found.pushes[word] / static_cast<double>(found.push_scale);
  };
  CHECK(metres(corner, 1) == doctest::Approx(0.1875).epsilon(1e-5));  // node 0 alone, from where it was
  for (const std::size_t node : {1U, 2U}) CHECK(corner.pushes[4 * node + 3] == 0);
  CHECK(corner.statistics.contacts == 1);
  CHECK(corner.statistics.contact_hash == hash_pair(0, contact::kConvexId));

  // A tip that looks through the triangle at weights of 1/2, 1/4, 1/4: its point goes up by the push.
  setup.hulls = {hull_of({{0, 0, 0}, {-1, -2, -1}, {1, -2, -1}, {0, -2, 1}})};
  pose.predicted = {{0, -0.0625F, -1, 1}, {1, -0.0625F, 1, 1}, {-1, -0.0625F, 1, 1}};
  pose.previous = pose.predicted;
  const Found tip = find_contacts(fixture.device(), pose, setup);
  double moved = 0;
  const double weights[] = {0.5, 0.25, 0.25};
  for (std::size_t node = 0; node < 3; ++node) {
    CHECK(tip.pushes[4 * node + 3] == 1);
    CHECK(metres(tip, 4 * node + 1) == doctest::Approx(0.3125 * weights[node] / 0.375).epsilon(1e-4));
    moved += weights[node] * metres(tip, 4 * node + 1);
  }
  CHECK(moved == doctest::Approx(0.3125).epsilon(1e-4));

  // What is kinematic takes its part and stays; what is not finite is not touched.
  pose.previous[0].w = pose.predicted[0].w = 0;
  const Found held = find_contacts(fixture.device(), pose, setup);
  CHECK(held.pushes[3] == 0);
  CHECK(metres(held, 5) == doctest::Approx(0.3125 * 0.25 / 0.375).epsilon(1e-4));
  pose.predicted[1].x = std::nanf("");
  const Found lost = find_contacts(fixture.device(), pose, setup);
  CHECK(lost.statistics.contacts == 0);
}
