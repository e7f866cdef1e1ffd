// Closest points and crossings of src/contact/proximity/ against double, feature by feature.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "base/random.hpp"
#include "contact/reference/proximity/audit.hpp"
#include "contact/reference/proximity/closest.hpp"
#include "gpu/gpu_fixture.hpp"
#include "gpu/kernel.hpp"
#include "gpu/readback.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

constexpr double kEpsilon = 1.0 / 16777216;  // of f32: half a unit in the last place of 1

struct Case {
  Vec3d p, a, b, c, q;
};
struct Measured {
  Vec3d corner_apart, edges_apart;
  double corner_s = 0, corner_t = 0, edges_s = 0, edges_t = 0;
  bool crosses = false, inside = false;
};

Vec3d rounded(const Vec3d& p) { return p.to<float>().to<double>(); }

/// Measures on the GPU, and rounds the cases to what it has seen.
std::vector<Measured> measure(gpu::Device& device, std::vector<Case>& cases) {
  std::vector<Vec4f> points;
  for (Case& x : cases)
    for (Vec3d* p : {&x.p, &x.a, &x.b, &x.c, &x.q}) {
      *p = rounded(*p);
      points.push_back(Vec4f::from(p->to<float>(), 0));
    }
  auto kernel = gpu::Kernel::create(device, "contact/test/contact_features.wgsl");
  REQUIRE_MESSAGE(kernel, kernel.error().message);
  auto input = gpu::Buffer<Vec4f>::create_from(device, points, "points");
  auto output = gpu::Buffer<Vec4f>::create(device, points.size(), "results");
  REQUIRE(input);
  REQUIRE(output);
  auto group = kernel->bind({*input, *output});
  REQUIRE(group);
  gpu::CommandList list;
  {
    gpu::ComputePass pass(list, "features");
    kernel->dispatch(pass, *group, cases.size());
  }
  REQUIRE(device.submit(list));
  auto results = gpu::download(device, *output);
  REQUIRE(results);
  std::vector<Measured> measured;
  for (std::size_t k = 0; k < results->size(); k += 5) {
    const Vec4f* r = results->data() + k;
    measured.push_back({r[0].xyz().to<double>(), r[2].xyz().to<double>(), r[1].x, r[1].y, r[3].x, r[3].y,
                        r[1].z != 0, r[3].z != 0});
  }
  return measured;
}

Vec3d random_point(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

std::vector<Case> random_cases(std::uint32_t count, double scale, const Vec3d& offset, std::uint64_t seed) {
  Random random(seed);
  std::vector<Case> cases;
  const auto point = [&] { return random_point(random, scale) + offset; };
  for (std::uint32_t i = 0; i < count; ++i) cases.push_back({point(), point(), point(), point(), point()});
  return cases;
}

/// The rounding of lengths: by the size of the features, and, as WGSL lets a compiler take differences
/// apart and put them together again, by the size of coordinates where that is larger.
struct Sizes {
  double features = 0, rounding = 0;
};
Sizes sizes_of(const Case& x) {
  const double size = std::max(
      {length(x.a - x.p), length(x.b - x.p), length(x.c - x.p), length(x.b - x.a), length(x.c - x.a)});
  return {size, kEpsilon * (16 * size + 6 * std::max({std::abs(x.p.x), std::abs(x.p.y), std::abs(x.p.z)}))};
}

struct Worst {
  double corner = 0, edges = 0;  // distance over the least, in sizes
};

/// Whether the direction between two places separates all of both features by their distance: to the rounding of
/// lengths where both are inside. Where one is at an end, to that of the direction too: by lengths, and by which of two
/// ends is nearer, whose distances differ by the square of what is between them. slip: how much longer than the least
/// the distance of parallel edges may be [m].
bool separates(const Measured& m, const Case& x, double size, double rounding, double slip) {
  const auto apart = [&](const Vec3d& between, double error, bool inside, std::initializer_list<Vec3d> first,
                         std::initializer_list<Vec3d> second) {
    const double distance = length(between);
    if (distance <= rounding) return true;
    const Vec3d n = between / distance;
    double least = 1e300;
    for (const Vec3d& one : first)
      for (const Vec3d& other : second) least = std::min(least, dot(n, one - other));
    const double turned = inside ? 0 : 2 * error / distance + std::sqrt(2 * kEpsilon);
    return least >= distance - error - turned * size;
  };
  const bool inside_face = m.corner_s > 0 && m.corner_t > 0 && m.corner_s + m.corner_t < 1 - 4 * kEpsilon;
  return apart(m.corner_apart, rounding, inside_face, {x.p}, {x.a, x.b, x.c}) &&
         apart(m.edges_apart, rounding + slip, m.inside, {x.p, x.a}, {x.b, x.c});
}

/// Places lie on their features and `apart` is what is between them; distances are no shorter than the least,
/// and longer only by rounding: cross products of a triangle with the altitude w of size L are good for a
/// place within ε L / w, those of edges at an angle of sine σ for one within ε / σ, which slips σ times that off
/// the line that is shortest, square to it. Below σ² = 1e-10 edges count as parallel, and lose up to σ of their
/// length.
Worst check_closest(const std::vector<Case>& cases, const std::vector<Measured>& measured, const char* what) {
  Worst worst;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto& [p, a, b, c, q] = cases[i];
    const Measured& m = measured[i];
    const auto [size, rounding] = sizes_of(cases[i]);
    const ClosestOnTriangle corner = closest_on_triangle(p, a, b, c);
    const ClosestSegments edges = closest_segments(p, a, b, c);
    const Vec3d on_face = a + m.corner_s * (b - a) + m.corner_t * (c - a);
    const Vec3d on_first = p + m.edges_s * (a - p), on_second = b + m.edges_t * (c - b);
    const double altitude =
        length(cross(b - a, c - a)) / std::max({length(b - a), length(c - a), length(c - b), 1e-300});
    const double sine = length(cross(a - p, c - b)) / std::max(length(a - p) * length(c - b), 1e-300);
    const double face_slip = altitude > 0 ? std::min(1.0, 32 * kEpsilon * size / altitude) * size : size;
    const double edge_slip = sine < 1e-5 + 8 * kEpsilon ? sine * size : 0;
    const double face = length(m.corner_apart), between = length(m.edges_apart);
    const bool places = m.corner_s >= 0 && m.corner_t >= 0 && m.corner_s + m.corner_t <= 1 + 4 * kEpsilon &&
                        m.edges_s >= 0 && m.edges_s <= 1 && m.edges_t >= 0 && m.edges_t <= 1;
    const bool consistent = length(p - on_face - m.corner_apart) <= rounding + face_slip &&
                            length(on_first - on_second - m.edges_apart) <= rounding;
    const bool separate = separates(m, cases[i], size, rounding, edge_slip);
    const bool least = face >= corner.distance - rounding && between >= edges.distance - rounding;
    const bool not_longer = face <= std::hypot(corner.distance, face_slip) + rounding &&
                            between <= edges.distance + rounding + edge_slip;
    if (size > 0) {
      worst.corner = std::max(worst.corner, (face - corner.distance) / size);
      worst.edges = std::max(worst.edges, (between - edges.distance) / size);
    }
    if (places && consistent && separate && least && not_longer) continue;
    if (++wrong <= 3)
      FAIL_CHECK(what, " case ", i, ": places ", places, ", consistent ", consistent, ", separate ", separate,
                 "; corner ", face, " m, least ", corner.distance, " m; edges ", between, " m, least ",
                 edges.distance, " m; size ", size, " m, altitude ", altitude, " m, sine ", sine);
  }
  CHECK(wrong == 0);
  std::printf("%s: worst %.2g of the size to a triangle, %.2g between edges\n", what, worst.corner,
              worst.edges);
  return worst;
}

}  // namespace

TEST_CASE("closest points of random features are those of double, at three scales and far from the origin") {
  GpuFixture fixture;
  for (const double scale : {1e-4, 1.0, 1e4}) {
    std::vector<Case> cases = random_cases(30000, scale, {}, 21);
    const std::vector<Measured> measured = measure(fixture.device(), cases);
    const Worst worst = check_closest(cases, measured, "random");
    CHECK(worst.corner < 1e-5);
    std::size_t inside = 0, same = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const ClosestSegments edges = closest_segments(cases[i].p, cases[i].a, cases[i].b, cases[i].c);
      inside += edges.inside_first() && edges.inside_second() ? 1 : 0;
      same += measured[i].inside == (edges.inside_first() && edges.inside_second()) ? 1 : 0;
    }
    CHECK(inside > 2000);
    CHECK(same >= cases.size() - 5);  // places within rounding of an end: about 1e-6 of them
  }
  std::vector<Case> cases = random_cases(30000, 100, {1e4, -1e4, 1e4}, 22);
  check_closest(cases, measure(fixture.device(), cases), "far");
}

TEST_CASE("closest points on triangles without area, slivers and features of one point are points of them") {
  GpuFixture fixture;
  Random random(23);
  std::vector<Case> cases = random_cases(30000, 1, {}, 24);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    auto& [p, a, b, c, q] = cases[i];
    const Vec3d on_line = a + random.uniform(-0.5, 1.5) * (b - a);
    if (i % 6 == 0) c = b;
    if (i % 6 == 1) b = c = a;
    if (i % 6 == 2) c = on_line;
    if (i % 6 == 3) c = on_line + random_point(random, std::pow(10, -1 - static_cast<int>(i / 6 % 7)));
    if (i % 6 == 4) p = i % 12 == 4 ? a : a + random.uniform(0, 1) * (b - a);
    if (i % 6 == 5) a = b = c = p;
  }
  check_closest(cases, measure(fixture.device(), cases), "degenerate");
}

TEST_CASE(
    "edges that are parallel, or nearly so, are as near as double says to a hundred-thousandth of their "
    "length") {
  GpuFixture fixture;
  Random random(25);
  std::vector<Case> cases = random_cases(30000, 1, {}, 26);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    auto& [p, a, b, c, q] = cases[i];
    const Vec3d shift = random_point(random, 0.3);
    const double tilt = i % 8 == 0 ? 0 : std::pow(10, -static_cast<int>(i % 8));
    b = p + shift, c = a + shift + random_point(random, tilt);
    if (i % 3 == 0) std::swap(b, c);
  }
  std::vector<Measured> measured = measure(fixture.device(), cases);
  CHECK(check_closest(cases, measured, "parallel").edges < 1e-5);
  for (std::size_t i = 0; i < cases.size(); ++i) {  // on a lattice of powers of two nothing is rounded
    auto& [p, a, b, c, q] = cases[i];
    const auto step = [&] { return 0.25 * (static_cast<double>(random.below(9)) - 4); };
    p = {step(), step(), step()}, a = {step(), step(), step()}, b = {step(), step(), step()};
    c = b + (i % 2 == 0 ? 1.0 : -0.5) * (a - p);
  }
  measured = measure(fixture.device(), cases);
  check_closest(cases, measured, "lattice");
  CHECK(std::none_of(measured.begin(), measured.end(), [](const Measured& m) { return m.inside; }));
}

TEST_CASE("a segment crosses a triangle where exact signs say so, touching left out") {
  GpuFixture fixture;
  Random random(27);
  std::vector<Case> cases = random_cases(60000, 1, {}, 28);
  // Every second on a lattice, where differences, products and their sums are whole and below 2^24.
  for (std::size_t i = 0; i < cases.size(); i += 2)
    for (Vec3d* p : {&cases[i].p, &cases[i].a, &cases[i].b, &cases[i].c, &cases[i].q}) {
      const std::uint32_t wide = i % 4 == 0 ? 5 : 64;
      *p = {static_cast<double>(random.below(wide)), static_cast<double>(random.below(wide)),
            static_cast<double>(random.below(wide))};
    }
  const std::vector<Measured> measured = measure(fixture.device(), cases);
  std::size_t crossing = 0, wrong = 0, differing = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto& [p, a, b, c, q] = cases[i];
    const bool exact = segment_crosses(p, q, a, b, c);
    crossing += exact ? 1 : 0;
    if (exact == measured[i].crosses) continue;
    if (i % 2 == 0)
      ++wrong;
    else
      ++differing;
  }
  std::printf("%zu of %zu cross; %zu differ\n", crossing, cases.size(), differing);
  CHECK(crossing > 3000);
  CHECK(wrong == 0);
  // A volume of up to 48 m³ is good for about 16 ε of that: of volumes spread over some m³ a millionth is in
  // doubt.
  CHECK(differing <= 2);
}
