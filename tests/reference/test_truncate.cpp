// Displacements that are cut at planes, and obstacles at a time.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "base/random.hpp"
#include "contact/reference/proximity/closest.hpp"
#include "contact/reference/proximity/may_meet.hpp"
#include "contact/reference/proximity/obstacles.hpp"
#include "contact/reference/proximity/separate.hpp"
#include "contact/reference/proximity/truncate.hpp"
#include "contact/reference/proximity/turned_plane.hpp"
#include "mesh/primitives.hpp"
#include "moved.hpp"
#include "scene/load.hpp"
#include "soup.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

constexpr Vec3d kUp{0, 1, 0};

/// A vertex and a triangle, or two edges, that are nearest inside.
struct TwoSides {
  ClothPair pair;
  std::vector<Vec3d> place;
};
Vec3d offset_of(const ClothPair& pair, std::span<const Vec3d> at) {
  return pair.count_a == 2 ? closest_segments(at[0], at[1], at[2], at[3]).offset
                           : closest_on_triangle(at[0], at[1], at[2], at[3]).offset;
}
Vec3d turned(const Vec3d& at, const Vec3d& axis, double angle) {
  const Vec3d along = dot(axis, at) * axis;
  return along + std::cos(angle) * (at - along) + std::sin(angle) * cross(axis, at);
}
TwoSides random_features(Random& random) {
  TwoSides made;
  for (int k = 0; k < 4; ++k) made.place.push_back(random_point(random, 1));
  const std::uint32_t count_a = 1 + random.below(2);
  made.pair = {count_a, 4 - count_a, {0, 1, 2, 3}, {}, 0, 0, 0, 0};
  const Vec3d offset = offset_of(made.pair, made.place);
  made.pair.normal = offset / length(offset);
  made.pair.gap = length(offset);
  made.pair.apart = 0.1 * made.pair.gap;
  return made;
}

/// Two nodes, A above B by 1.
ClothPair above(std::uint32_t a, std::uint32_t b, double middle, double margin) {
  return {1, 1, {a, b}, kUp, middle, margin, 2 * margin, 1};
}

}  // namespace

TEST_CASE("a way goes on along the plane of an obstacle, and ends at its reach") {
  const auto cut = [&](std::vector<SolidPlane> planes, Vec3d from, Vec3d to, double reach,
                       double inverse = 1) {
    Moved moved;
    moved.add(from, to, inverse);
    const Truncated count = moved.cut(planes, {}, reach);
    CHECK(count.vertices == (moved.end[0] == to ? 0 : 1));
    CHECK(count.driven == 0);
    return moved;
  };
  CHECK(cut({}, {0, 0, 0}, {3, 4, 0}, 6).end[0] == Vec3d{3, 4, 0});
  CHECK(cut({}, {0, 0, 0}, {3, 4, 0}, 2.5).end[0] == Vec3d{1.5, 2, 0});
  CHECK(cut({{0, kUp, 0}, {0, kUp, 0.5}}, {0, 1, 0}, {4, -1, 0}, 9).end[0] == Vec3d{4, 0.5, 0});
  CHECK(cut({{0, kUp, 0}, {0, kUp, 0.5}}, {0, 1, 0}, {4, -1, 0}, 9).velocity[0] == Vec3d{4, -0.5, 0});
  CHECK(cut({{0, kUp, 0}}, {0, 1, 0}, {4, 0.25, 0}, 9).end[0] == Vec3d{4, 0.25, 0});
  // An obstacle that has come past it takes it along, with its own speed and no more.
  const Moved carried = cut({{0, kUp, 2, 0.5}}, {0, 1, 0}, {4, 0.75, 0}, 9);
  CHECK(carried.end[0] == Vec3d{4, 2, 0});
  CHECK(carried.velocity[0] == Vec3d{4, 0.5, 0});
  CHECK(cut({{0, kUp, 2, 0.5}}, {0, 1, 0}, {0, 1.75, 0}, 9).velocity[0] == Vec3d{0, 0.75, 0});
  CHECK(cut({{0, kUp, 0}}, {0, 1, 0}, {0, -1, 0}, 9, 0).end[0] == Vec3d{0, -1, 0});
}

TEST_CASE(
    "a way that several planes bound ends before all of them, and is neither longer nor faster than it was") {
  Random random(7);
  int slid = 0, wedged = 0;
  for (int k = 0; k < 20'000; ++k) {
    const Vec3d start = random_point(random, 1), end = start + 3 * random_point(random, 1);
    std::vector<SolidPlane> planes;
    for (std::uint32_t p = 1 + random.below(5); p > 0; --p) {
      const Vec3d point = random_point(random, 1), normal = (1 / length(point)) * point;
      planes.push_back({0, normal, dot(normal, start) - 0.5 * random.uniform(0, 1), 0, kNoCollider, 1});
    }
    Moved moved;
    moved.add(start, end);
    const double reach = 4 * random.uniform(0, 1);
    moved.cut(planes, {}, reach);
    const Vec3d &at = moved.end[0], &v = moved.velocity[0];
    for (const SolidPlane& plane : planes) CHECK(dot(plane.normal, at) > plane.offset - 1.01e-5);
    CHECK(length(at - start) <= std::min(reach, length(end - start)) + 1e-12);
    CHECK(length(v) <= length(end - start) + 1e-12);
    if (planes.size() > 1 || length(end - start) > reach) continue;
    // Of one plane it keeps all that is along the plane.
    const Vec3d n = planes[0].normal;
    const bool past = dot(n, end) < planes[0].offset;
    const Vec3d along = end - dot(n, end) * n;
    CHECK(length(at - dot(n, at) * n - along) < 1e-12);
    CHECK(length(v - dot(n, v) * n - (along - start + dot(n, start) * n)) < 1e-12);
    ++(past ? slid : wedged);
  }
  CHECK(slid > 100);
  CHECK(wedged > 100);
}

namespace {

/// Two features that go straight from where they are to where they end: how near they come, of many times.
double nearest_on_ways(const MovingPair& pair) {
  double nearest = 1e9;
  for (int k = 0; k <= 200; ++k) {
    std::array<Vec3d, 4> at;
    for (std::size_t c = 0; c < 4; ++c) at[c] = pair.start[c] + (k / 200.0) * (pair.end[c] - pair.start[c]);
    nearest =
        std::min(nearest, pair.count_a == 2 ? closest_segments(at[0], at[1], at[2], at[3]).distance
                                            : length(closest_on_triangle(at[0], at[1], at[2], at[3]).offset));
  }
  return nearest;
}

}  // namespace

TEST_CASE("what ends before its turned plane passes through nothing, also where an obstacle moves") {
  Random random(11);
  int turned_planes = 0;
  for (int k = 0; k < 5'000; ++k) {
    const TwoSides sides = random_features(random);
    const std::uint32_t count_a = sides.pair.count_a;
    const bool cloth_is_a = random.below(2) == 0;
    const double gap = sides.pair.gap, thickness = gap * (0.5 + random.uniform(0, 1)),
                 margin = 0.1 * thickness;
    MovingPair pair{count_a, 4 - count_a, {}, {}};
    const Vec3d way = 5 * gap * random_point(random, 1), other_way = gap * random_point(random, 1);
    for (std::uint32_t c = 0; c < 4; ++c) {
      const bool of_cloth = (c < count_a) == cloth_is_a;
      pair.start[c] = sides.place[c];
      pair.end[c] = pair.start[c] + (of_cloth ? way + gap * random_point(random, 1) : other_way);
    }
    const Vec3d n = turned_normal(pair, sides.pair.normal, gap, margin);
    CHECK(std::abs(length(n) - 1) < 1e-12);
    turned_planes += n != sides.pair.normal;
    // As the planes of cloth are: before what the other side reaches at the end.
    const double side = cloth_is_a ? 1 : -1;
    double reach = -1e9;
    for (std::uint32_t c = 0; c < 4; ++c)
      if ((c < count_a) != cloth_is_a) reach = std::max(reach, side * dot(n, pair.end[c]));
    for (std::uint32_t c = 0; c < 4; ++c) {
      if ((c < count_a) != cloth_is_a) continue;
      pair.end[c] += std::max(0.0, reach + margin - side * dot(n, pair.end[c])) * (side * n);
    }
    CHECK(nearest_on_ways(pair) > 0.9 * std::min(margin, gap));
  }
  CHECK(turned_planes > 1'000);
}

TEST_CASE("what slides along a flat floor is beyond no plane of its triangles") {
  Random random(13);
  for (int k = 0; k < 5'000; ++k) {
    const double height = 0.2 + random.uniform(0, 1), margin = 0.1 * height;
    const auto on_floor = [&](double size) {
      const Vec3d point = random_point(random, size);
      return Vec3d{point.x, 0, point.z};
    };
    MovingPair pair{1, 3, {}, {}};
    pair.start = {on_floor(6) + height * kUp, on_floor(1), on_floor(1), on_floor(1)};
    pair.end = pair.start;
    pair.end[0] = on_floor(6) + height * kUp;
    const Vec3d offset =
        closest_on_triangle(pair.start[0], pair.start[1], pair.start[2], pair.start[3]).offset;
    const Vec3d n = turned_normal(pair, (1 / length(offset)) * offset, length(offset), margin);
    for (std::uint32_t c = 1; c < 4; ++c) CHECK(dot(n, pair.end[0] - pair.end[c]) >= margin);
  }
}

TEST_CASE("nodes that fly together keep their ways, however near they are to each other") {
  Moved moved;
  moved.add({0, 1, 0}, {0, -5, 0});
  moved.add({0, 0, 0}, {3, -6, 0});
  const std::vector<Vec3d> end = moved.end;
  CHECK(moved.cut({}, {above(0, 1, 0.5, 0.1)}, 99, 6).vertices == 0);
  CHECK(moved.end == end);
}

TEST_CASE("a stop goes down through a pile: what comes after ends its way before what was stopped") {
  // Node 0 stands on a floor, the others fall on it in a column with gaps of 1, all by 5.
  Moved moved;
  std::vector<ClothPair> pairs;
  for (std::uint32_t k = 0; k < 6; ++k) {
    moved.add({0, 1.0 * k, 0}, {0, k - 5.0, 0});
    if (k > 0) pairs.push_back(above(k, k - 1, k - 0.5, 0.05));
  }
  const Truncated count = moved.cut({{0, kUp, -0.1}}, pairs, 99);
  CHECK(count.vertices == 6);
  CHECK(count.driven == 0);
  for (std::uint32_t k = 1; k < 6; ++k) CHECK(moved.end[k].y - moved.end[k - 1].y >= 0.1 - 1e-12);
}

TEST_CASE("a substep that ends before its time is one that has gone some of its way: all but time is kept") {
  // Node 0 stands, the others fly into it in a column with gaps of 1, all by 5, beside one that meets nothing.
  const auto flown = [](std::uint64_t most_delay) {
    Moved moved;
    std::vector<ClothPair> pairs;
    for (std::uint32_t k = 0; k < 9; ++k) {
      moved.add({0, 1.0 * k, 0}, {0, k == 0 ? 0 : k - 5.0, 0}, k == 0 ? 0 : 1);
      moved.velocity_before.back() = {k == 8 ? 7.0 : 0, 1, 0};
      if (k > 0 && k < 8) pairs.push_back(above(k, k - 1, k - 0.5, 0.05));
    }
    return std::pair(moved, moved.cut({}, pairs, 99, 0, most_delay));
  };
  const auto [held, held_count] = flown(0);
  CHECK(held_count.vertices == 7);
  CHECK(held_count.delay == 0);
  const auto [moved, count] = flown(1000000);
  REQUIRE(count.delay > 0);
  CHECK(count.vertices < 7);
  const double part = (moved.end[8] - moved.start[8]).y / -5;
  CHECK(count.delay == doctest::Approx(1e6 * (1 - part)).epsilon(1e-5).scale(0));
  for (std::uint32_t k = 1; k < 9; ++k) {
    CHECK(moved.nearest(k, k == 8 ? 0 : k - 1) >= (k == 8 ? 0 : 0.1 - 1e-12));
    if (k < 6) continue;  // those below were marked, and had lost some of their way before
    CHECK(length(moved.end[k] - moved.start[k] - part * Vec3d{0, -5, 0}) < 1e-12);
    const Vec3d before = moved.velocity_before[k];
    CHECK(length(moved.velocity[k] - before - part * (Vec3d{0, -5, 0} - before)) < 1e-12);
  }
  CHECK(flown(count.delay / 2).second.delay == 0);  // no more than it may
  CHECK(flown(count.delay / 2).first.end == held.end);
}

TEST_CASE("however many substeps end before their time, what is pressed comes no nearer than half a margin") {
  constexpr double kMargin = 0.05;
  std::vector<Vec3d> places;
  for (std::uint32_t k = 0; k < 9; ++k) places.push_back({0, 1.0 * k, 0});
  int delayed = 0;
  for (int substep = 0; substep < 100; ++substep) {
    Moved moved;
    std::vector<ClothPair> pairs;
    for (std::uint32_t k = 0; k < 9; ++k) {
      moved.add(places[k], places[k] - Vec3d{0, k == 0 ? 0 : 5.0, 0}, k == 0 ? 0 : 1);
      if (k == 0) continue;
      const double gap = places[k].y - places[k - 1].y, middle = 0.5 * (places[k].y + places[k - 1].y);
      pairs.push_back({1, 1, {k, k - 1}, kUp, middle, kMargin, std::min(gap, 2 * kMargin), gap});
    }
    if (moved.cut({}, pairs, 99, 0, 1000000).delay > 0) ++delayed;
    places = moved.end;
    for (std::uint32_t k = 1; k < 9; ++k) CHECK(places[k].y - places[k - 1].y >= 0.5 * kMargin - 1e-12);
  }
  MESSAGE(delayed, " of 100 substeps end before their time");
  CHECK(delayed > 0);
}

TEST_CASE("random columns that fly into what stands keep apart all along, whatever they lose of their time") {
  Random random(62);
  int delayed = 0, held = 0;
  for (int round = 0; round < 300; ++round) {
    Moved moved;
    std::vector<ClothPair> pairs;
    double y = 0;
    for (std::uint32_t k = 0; k < 10; ++k) {
      const Vec3d from = Vec3d{0, y, 0} + 0.2 * random_point(random, 1);
      moved.add(from, k == 0 ? from : from + Vec3d{0, -5, 0} + random_point(random, 1), k == 0 ? 0 : 1);
      y += random.uniform(0.5, 1.5);
      for (std::uint32_t below = k < 2 ? 0 : k - 2; below < k; ++below) {
        const Vec3d apart = from - moved.start[below];
        const double gap = length(apart);
        pairs.push_back({1,
                         1,
                         {k, below},
                         apart / gap,
                         dot(apart / gap, 0.5 * (from + moved.start[below])),
                         0.05 * gap,
                         0.1 * gap,
                         gap});
      }
    }
    const Truncated count = moved.cut({}, pairs, 99, 0, static_cast<std::uint64_t>(random.uniform(0, 1.2e6)));
    for (const ClothPair& pair : pairs)
      CHECK(moved.nearest(pair.nodes[0], pair.nodes[1]) >= 2 * pair.margin - 1e-12);
    ++(count.delay > 0 ? delayed : held);
  }
  CHECK(delayed > 50);
  CHECK(held > 50);
}

TEST_CASE("two sides that are separated end as far apart as asked, without momentum and with less energy") {
  Random random(62);
  for (int round = 0; round < 20000; ++round) {
    BothSides sides{1 + random.below(2), 0};
    sides.count_b = 4 - sides.count_a;
    const double gap = random.uniform(0.01, 1);
    std::array<double, 4> way{};
    for (std::uint32_t k = 0; k < 4; ++k) {
      const double start = k < sides.count_a ? gap + random.uniform(0, 1) : -random.uniform(0, 1);
      sides.stays[k] = random.below(6) == 0;
      sides.mass[k] = sides.stays[k] ? 0 : random.uniform(0.1, 10);
      way[k] = sides.stays[k] ? 0 : random.uniform(-3, 3);
      sides.along[k] = start + way[k];
    }
    const bool meet = sides.apart() < gap;
    const std::array<double, 4> shifts = separated(sides, gap);
    double moment = 0, energy = 0;
    bool all_move = true;
    for (std::uint32_t k = 0; k < 4; ++k) {
      all_move = all_move && !sides.stays[k];
      if (sides.stays[k]) {
        CHECK(shifts[k] == 0);
        continue;
      }
      CHECK((k < sides.count_a ? shifts[k] >= 0 : shifts[k] <= 0));
      moment += sides.mass[k] * shifts[k];
      energy += sides.mass[k] * ((way[k] + shifts[k]) * (way[k] + shifts[k]) - way[k] * way[k]);
      sides.along[k] += shifts[k];
    }
    CHECK(sides.apart() >= gap - 1e-12);
    CHECK(energy <= 1e-12);
    if (all_move) CHECK(std::abs(moment) < 1e-12);
    if (!meet) CHECK(std::all_of(shifts.begin(), shifts.end(), [](double shift) { return shift == 0; }));
  }
}

TEST_CASE("what strikes in flight keeps its momentum and the motion of all, and gains no energy") {
  Random random(63);
  const Vec3d together{3, -50, 2};
  for (int round = 0; round < 100; ++round) {
    // A pile of eight, each as heavy as it happens, with gaps of 1.
    Moved moved;
    std::vector<ClothPair> pairs;
    for (std::uint32_t k = 0; k < 8; ++k) {
      const Vec3d from{0, 1.0 * k, 0};
      moved.add(from, from + together + random_point(random, 1), random.uniform(0.5, 2));
      if (k > 0) pairs.push_back(above(k, k - 1, k - 0.5, 0.05));
    }
    const Vec3d momentum = moved.momentum();
    const double kinetic = moved.kinetic();
    const std::vector<Vec3d> velocity = moved.velocity;
    const Truncated count = moved.cut({}, pairs, 999, 60);
    CHECK(count.vertices == 0);
    CHECK(length(moved.momentum() - momentum) < 1e-9);
    CHECK(moved.kinetic() <= kinetic + 1e-9);
    for (std::uint32_t k = 0; k < 8; ++k) {
      CHECK(moved.velocity[k].x == velocity[k].x);
      CHECK(length(moved.end[k] - moved.start[k] - moved.velocity[k]) < 1e-9);
      if (k > 0) CHECK(moved.nearest(k, k - 1) >= 0.1 - 1e-9);
    }
  }
}

TEST_CASE("however many pairs strike one vertex at once, no energy is gained and momentum is kept") {
  Random random(64);
  for (int round = 0; round < 400; ++round) {
    // The pole and the rim of a fan of 48 triangles, and a striker over each. By whole masses the pairs move the rim
    // and the striker alone; by shared ones, a lighter rim, the plane would come past the pole too.
    constexpr std::uint32_t kRim = 48;
    Moved moved;
    const auto add = [&](double height, double way, double mass) {
      moved.add({0, height, 0}, {0, height + way, 0}, 1 / mass);
    };
    add(0, random.uniform(-0.85, -0.65), random.uniform(12, 17));
    for (std::uint32_t k = 0; k < kRim; ++k) add(0, random.uniform(1.6, 2), 6.57);
    std::vector<ClothPair> pairs;
    for (std::uint32_t k = 0; k < kRim; ++k) {
      add(1, random.uniform(-4.1, -3.7), 10.3);
      pairs.push_back({1, 3, {1 + kRim + k, 0, 1 + k, 1 + (k + 1) % kRim}, kUp, 0.5, 0.05, 0.1, 1});
    }
    const Vec3d momentum = moved.momentum();
    double kinetic = moved.kinetic();
    for (int blow = 0; blow < 20; ++blow) {
      separate({}, pairs, 999, {moved.start, moved.inverse_mass, moved.end, moved.velocity});
      CHECK(moved.kinetic() <= kinetic * (1 + 1e-12));
      CHECK(length(moved.momentum() - momentum) < 1e-9);
      kinetic = moved.kinetic();
    }
  }
}

TEST_CASE("what is separated stays before obstacles and within its reach") {
  Moved moved;
  moved.add({0, 0.2, 0}, {0, 0.1, 0});
  moved.add({0, 1.2, 0}, {0, -1.8, 0}, 0.01);  // heavy
  const std::vector<ClothPair> pairs{above(1, 0, 0.7, 0.05)};
  moved.cut({{0, kUp, 0}}, pairs, 5, 6);
  CHECK(moved.end[0].y >= 0);
  CHECK(moved.end[1].y - moved.end[0].y >= 0.1 - 1e-12);
  Moved near;
  near.add({0, 0.2, 0}, {0, 0.1, 0});
  near.add({0, 1.2, 0}, {0, 0.2, 0}, 0.01);
  near.cut({}, pairs, 0.15, 6);
  CHECK(length(near.end[0] - near.start[0]) <= 0.15 + 1e-12);
}

TEST_CASE("an obstacle does not drive one layer through another that stays: it is counted") {
  Moved moved;
  moved.add({0, 0, 0}, {0, 0, 0});  // the floor comes up by 0.9 under it
  moved.add({0, 1, 0}, {0, 1, 0});
  const Truncated count = moved.cut({{0, kUp, 0.9, 3}}, {above(1, 0, 0.5, 0.05)}, 99);
  CHECK(count.driven == 1);
  CHECK(moved.end[0].y < 0.5);
  CHECK(moved.end[1].y == 1);
}

TEST_CASE("random ways of random pairs keep apart all along, whatever each was cut by") {
  Random random(61);
  for (int round = 0; round < 300; ++round) {
    Moved moved;
    std::vector<ClothPair> pairs;
    for (int k = 0; k < 12; ++k) {
      const Vec3d from = random_point(random, 1);
      moved.add(from, from + random_point(random, 1), random.below(8) == 0 ? 0 : 1);
      if (moved.inverse_mass.back() == 0) moved.end.back() = from;
    }
    for (int k = 0; k < 20; ++k) {
      const std::uint32_t a = random.below(12), b = (a + 1 + random.below(11)) % 12;
      const Vec3d apart = moved.start[a] - moved.start[b];
      const Vec3d n = apart / length(apart);
      pairs.push_back({1,
                       1,
                       {a, b},
                       n,
                       dot(n, 0.5 * (moved.start[a] + moved.start[b])),
                       0.05 * length(apart),
                       0.1 * length(apart),
                       length(apart)});
    }
    moved.cut({}, pairs, 10, round % 2 == 0 ? 0 : 6);
    for (const ClothPair& pair : pairs)
      CHECK(moved.nearest(pair.nodes[0], pair.nodes[1]) >= 2 * pair.margin - 1e-12);
  }
}

TEST_CASE("features that are said not to meet keep apart all along") {
  Random random(65);
  int apart = 0, met = 0;
  for (int round = 0; round < 20000; ++round) {
    const TwoSides features = random_features(random);
    // Both sides turn and fly together, and each vertex goes a way of its own.
    const Vec3d axis = random_point(random, 1), way = random_point(random, 2);
    const double angle = random.uniform(0, 2), own = random.uniform(0, 1);
    std::vector<Vec3d> end;
    for (const Vec3d& at : features.place)
      end.push_back(turned(at, axis / length(axis), angle) + way + random_point(random, own));
    if (may_meet(features.pair, features.place, end)) {
      ++met;
      continue;
    }
    ++apart;
    for (int k = 0; k <= 100; ++k) {
      std::vector<Vec3d> then;
      for (int v = 0; v < 4; ++v) then.push_back(features.place[v] + 0.01 * k * (end[v] - features.place[v]));
      CHECK(length(offset_of(features.pair, then)) >= features.pair.apart - 1e-12);
    }
  }
  MESSAGE(apart, " keep apart, ", met, " may meet");
  CHECK(apart > 2000);
  CHECK(met > 2000);
}

TEST_CASE("features that turn over together do not meet, however far they then reach along n") {
  Random random(66);
  for (int round = 0; round < 5000; ++round) {
    const TwoSides features = random_features(random);
    const Vec3d axis = cross(features.pair.normal, random_point(random, 1)), way = random_point(random, 5);
    const double angle = random.uniform(0, 1.4);
    std::vector<Vec3d> end;
    for (const Vec3d& at : features.place) end.push_back(turned(at, axis / length(axis), angle) + way);
    CHECK_FALSE(may_meet(features.pair, features.place, end));
    // One side goes through the other.
    const Vec3d through = 2.5 * features.pair.gap * features.pair.normal;
    for (std::uint32_t k = 0; k < 4; ++k)
      end[k] = features.place[k] - (k < features.pair.count_a ? through : Vec3d{});
    CHECK(may_meet(features.pair, features.place, end));
  }
}

TEST_CASE("obstacles are where motions and keyframes have taken them") {
  const auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"},
      "contact": {"method": "proximity"},
    "cloths": [{"grid": [2, 2], "size": [1, 1], "density": 1}],
    "colliders": [{"kind": "sphere", "center": [1, 0, 0], "radius": 0.5, "friction": 0.7},
      {"kind": "mesh", "mesh": "box", "keyframes": [{"time": 1, "mesh": "b"}, {"time": 3, "mesh": "c"}],
       "motion": {"kind": "line", "direction": [0, 0, 1], "speed": 2}},
      {"kind": "capsule", "a": [0, 0, 0], "b": [1, 0, 0], "radius": 0.1},
      {"kind": "plane", "point": [1, 0, 0], "normal": [1, 0, 0],
       "motion": {"kind": "rotation", "axis": [0, 1, 0], "center": [0, 0, 0], "speed": 1}}]})",
                                        "test.json");
  REQUIRE_MESSAGE(scene, scene.error().message);
  const mesh::TriangleMesh box = mesh::make_box({2, 2, 2});
  mesh::TriangleMesh wide = box, high = box;
  for (Vec3f& p : wide.positions) p.x *= 3;
  for (Vec3f& p : high.positions) p.y += 8;
  const mesh::Deformation deformation{{{1, 3}}, {wide.positions, high.positions}};
  const Obstacles obstacles(*scene, {&box, 1}, {&deformation, 1});
  CHECK_FALSE(obstacles.still());
  CHECK(obstacles.features().vertices.size() == 8 + 1 + 2);
  CHECK(obstacles.features().edges.size() == 18 + 1);
  CHECK(obstacles.features().radius_of_vertex(3) == 0);
  CHECK(obstacles.features().radius_of_vertex(8) == 0.5);
  CHECK(obstacles.features().radius_of_edge(0) == 0);
  CHECK(obstacles.features().radius_of_edge(18) == 0.1);
  CHECK(obstacles.collider_of_vertex(0) == 1);
  CHECK(obstacles.collider_of_vertex(8) == 0);
  CHECK(obstacles.collider_of_vertex(10) == 2);
  CHECK(obstacles.friction(0) == 0.7);
  CHECK_FALSE(obstacles.friction(1));
  for (const auto& [time, stretch, lift] : {std::tuple{0.0, 1.0, 0.0},
                                            {0.5, 2.0, 0.0},
                                            {1.0, 3.0, 0.0},
                                            {2.5, 1.5, 6.0},
                                            {3.0, 1.0, 8.0},
                                            {9.0, 1.0, 8.0}}) {
    const Obstacles::Placed placed = obstacles.at(time);
    for (std::size_t v = 0; v < 8; ++v) {
      const Vec3d rest = box.positions[v].to<double>();
      CHECK(length(placed.positions[v] - Vec3d{stretch * rest.x, rest.y + lift, rest.z + 2 * time}) <
            1e-14 * (1 + time));
    }
    CHECK(placed.positions[8] == Vec3d{1, 0, 0});
    // Turned about y: x goes to (cos, 0, -sin).
    const Vec3d expected{std::cos(time), 0, -std::sin(time)};
    CHECK(length(placed.planes[0].normal - expected) < 1e-15);
    CHECK(length(placed.planes[0].point - expected) < 1e-15);
    const Vec3d point{0.3, -0.2, 0.9};
    CHECK(length(carried(placed.transforms[3](point), placed.transforms[3], obstacles.at(7).transforms[3]) -
                 obstacles.at(7).transforms[3](point)) < 1e-15);
  }
}
