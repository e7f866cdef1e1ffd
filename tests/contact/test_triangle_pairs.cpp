// The narrow phase of src/contact/pushes/triangle_pair.wgsl, pair by pair.
#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "base/random.hpp"
#include "contact/reference/pushes/lattice.hpp"
#include "contact/reference/pushes/segment_triangle.hpp"
#include "gpu/gpu_fixture.hpp"
#include "gpu/kernel.hpp"
#include "gpu/readback.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

constexpr std::uint32_t kEdgeHits = 1, kBoxesOverlap = 2;

/// Results of contact/test/triangle_pairs.wgsl for pairs of six corners each.
std::vector<std::uint32_t> run_pairs(gpu::Device& device, const std::vector<Vec4f>& corners) {
  auto kernel = gpu::Kernel::create(device, "contact/test/triangle_pairs.wgsl");
  REQUIRE_MESSAGE(kernel, kernel.error().message);
  auto input = gpu::Buffer<Vec4f>::create_from(device, corners, "corners");
  auto output = gpu::Buffer<std::uint32_t>::create(device, corners.size() / 6, "results");
  REQUIRE(input);
  REQUIRE(output);
  auto group = kernel->bind({*input, *output});
  REQUIRE(group);
  gpu::CommandList list;
  {
    gpu::ComputePass pass(list, "pairs");
    kernel->dispatch(pass, *group, output->size());
  }
  REQUIRE(device.submit(list));
  auto results = gpu::download(device, *output);
  REQUIRE(results);
  return *results;
}

struct LatticePair {
  LatticeTriangle cloth, object;
};

/// Checks that the GPU finds exactly the pairs that integers find; returns their number.
std::size_t check_lattice(gpu::Device& device, const std::vector<LatticePair>& pairs) {
  std::vector<Vec4f> corners;
  for (const LatticePair& pair : pairs)
    for (const LatticeTriangle* triangle : {&pair.cloth, &pair.object})
      for (const LatticePoint& p : *triangle)
        corners.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]), 0});
  const std::vector<std::uint32_t> results = run_pairs(device, corners);
  std::size_t hits = 0, wrong = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const bool exact = triangles_meet(pairs[i].cloth, pairs[i].object);
    const bool found = (results[i] & kEdgeHits) != 0;
    hits += exact ? 1 : 0;
    wrong += exact != found || (exact && (results[i] & kBoxesOverlap) == 0) ? 1 : 0;
  }
  CHECK(wrong == 0);
  std::printf("%zu lattice pairs, %zu intersect\n", pairs.size(), hits);
  return hits;
}

LatticePoint random_point(Random& random, std::int64_t half) {
  const auto coordinate = [&] {
    return static_cast<std::int64_t>(random.below(static_cast<std::uint32_t>(2 * half + 1))) - half;
  };
  return {coordinate(), coordinate(), coordinate()};
}
LatticeTriangle random_triangle(Random& random, std::int64_t half) {
  return {random_point(random, half), random_point(random, half), random_point(random, half)};
}

struct RealPair {
  TrianglePoints cloth, object;
};

void append(std::vector<Vec4f>& corners, const TrianglePoints& t) {
  for (const Vec3d& p : {t.a, t.b, t.c}) corners.push_back(Vec4f::from(p.to<float>(), 0));
}

/// Checks every pair but the ambiguous against double; returns the share of those.
double check_real(gpu::Device& device, const std::vector<RealPair>& pairs, const char* what) {
  std::vector<Vec4f> corners;
  for (const RealPair& pair : pairs) append(corners, pair.cloth), append(corners, pair.object);
  const std::vector<std::uint32_t> results = run_pairs(device, corners);
  std::size_t hits = 0, ambiguous = 0, wrong = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto point = [&](std::size_t k) { return corners[6 * i + k].xyz().to<double>(); };
    const Verdict verdict = triangle_pair({point(0), point(1), point(2)}, {point(3), point(4), point(5)});
    hits += verdict == Verdict::Hit ? 1 : 0;
    ambiguous += verdict == Verdict::Ambiguous ? 1 : 0;
    if (verdict == Verdict::Ambiguous) continue;
    const std::uint32_t expected = verdict == Verdict::Hit ? kEdgeHits : 0;
    wrong += (results[i] & kEdgeHits) != expected ? 1 : 0;
    if (verdict == Verdict::Hit) wrong += (results[i] & kBoxesOverlap) == 0 ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(hits > pairs.size() / 50);
  const double share = static_cast<double>(ambiguous) / static_cast<double>(pairs.size());
  std::printf("%s: %zu pairs, %zu hit, ambiguous %.2g\n", what, pairs.size(), hits, share);
  return share;
}

std::vector<RealPair> random_pairs(std::uint32_t count, std::uint64_t seed, double scale,
                                   const Vec3d& offset) {
  Random random(seed);
  const auto point = [&](double range) {
    return Vec3d{random.uniform(-range, range), random.uniform(-range, range), random.uniform(-range, range)};
  };
  std::vector<RealPair> pairs;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3d center = point(0.3);
    const auto near_center = [&] { return scale * (center + point(0.5)) + offset; };
    const auto anywhere = [&] { return scale * point(0.5) + offset; };
    pairs.push_back({{anywhere(), anywhere(), anywhere()}, {near_center(), near_center(), near_center()}});
  }
  return pairs;
}

}  // namespace

TEST_CASE("all pairs of triangles on the corners of a cube are found as in integers, degenerate ones too") {
  GpuFixture fixture;
  std::vector<LatticeTriangle> triangles;
  const auto corner = [](std::int64_t i) { return LatticePoint{i & 1, (i >> 1) & 1, (i >> 2) & 1}; };
  for (std::int64_t i = 0; i < 512; ++i)
    triangles.push_back({corner(i & 7), corner((i >> 3) & 7), corner(i >> 6)});
  std::vector<LatticePair> pairs;
  for (const LatticeTriangle& cloth : triangles)
    for (const LatticeTriangle& object : triangles) pairs.push_back({cloth, object});
  CHECK(check_lattice(fixture.device(), pairs) > 1000);
}

TEST_CASE("all triangles of a 3 x 3 x 3 lattice are found as in integers against forty others") {
  GpuFixture fixture;
  Random random(3);
  const auto point = [](std::uint32_t i) { return LatticePoint{i % 3, i / 3 % 3, i / 9}; };
  std::vector<LatticePair> pairs;
  for (int k = 0; k < 40; ++k) {
    const LatticeTriangle object = {point(random.below(27)), point(random.below(27)),
                                    point(random.below(27))};
    for (std::uint32_t a = 0; a < 27; ++a)
      for (std::uint32_t b = a + 1; b < 27; ++b)
        for (std::uint32_t c = b + 1; c < 27; ++c) pairs.push_back({{point(a), point(b), point(c)}, object});
  }
  CHECK(check_lattice(fixture.device(), pairs) > 1000);
}

TEST_CASE(
    "random pairs on a lattice are found as in integers: apart, touching, sharing corners, coplanar, "
    "slivers") {
  GpuFixture fixture;
  Random random(1);
  constexpr std::int64_t kHalf = kLatticeExtent / 2;
  std::vector<LatticePair> pairs;
  for (int i = 0; i < 250000; ++i) {
    const std::int64_t half = i % 2 == 0 ? kHalf : 3;  // small lattices touch often
    LatticePair pair{random_triangle(random, half), random_triangle(random, half)};
    switch (i % 10) {
      case 1:
        pair.cloth[0] = pair.object[random.below(3)];
        break;  // a corner
      case 2:
        pair.cloth[0] = pair.object[1], pair.cloth[1] = pair.object[0];
        break;  // an edge
      case 3:
        for (auto& p : pair.cloth) p[2] = 0;
        for (auto& p : pair.object) p[2] = 0;
        break;  // coplanar
      case 4:
        for (std::size_t k = 0; k < 3; ++k) pair.object[2][k] = pair.object[1][k];  // a line
        pair.object[2][0] = std::min(pair.object[2][0] + 1, half);
        break;  // or a sliver
      case 5:
        for (std::size_t k = 0; k < 3; ++k)  // on an edge
          pair.cloth[0][k] = (pair.object[0][k] + pair.object[1][k]) / 2;
        break;
      case 6:
        for (auto& p : pair.object) p[1] = 0;
        pair.cloth[0][1] = 0;
        break;  // in the plane
      default:
        break;
    }
    pairs.push_back(pair);
  }
  CHECK(check_lattice(fixture.device(), pairs) > 20000);
}

TEST_CASE("random real pairs are found as in double wherever rounding leaves no doubt") {
  GpuFixture fixture;
  CHECK(check_real(fixture.device(), random_pairs(200000, 1, 1, {}), "scale 1") < 1e-3);
  CHECK(check_real(fixture.device(), random_pairs(50000, 2, 1e-4, {}), "scale 1e-4") < 1e-3);
  CHECK(check_real(fixture.device(), random_pairs(50000, 3, 1e4, {}), "scale 1e4") < 1e-3);
  // Coordinates are multiples of 1/128 there: the inputs are coarse, the verdict on them is not.
  CHECK(check_real(fixture.device(), random_pairs(50000, 4, 1, {1e5, -1e5, 1e5}), "offset 1e5") < 0.02);
  CHECK(check_real(fixture.device(), random_pairs(50000, 5, 1e3, {1e5, -1e5, 1e5}), "scale 1e3, offset 1e5") <
        1e-3);
}
