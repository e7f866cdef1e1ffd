// Where vertices may be until the next search, and which pairs of features may then come within a distance, in double:
// docs/contact.md, Reach. What is listed by it is tested against motions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "contact/reference/proximity/closest.hpp"
#include "contact/reference/proximity/pairs.hpp"

namespace weft {

/// All places within the slack of the segment from a place along its way ahead [m].
struct MotionSet {
  Vec3d place;
  double slack = 0;
  Vec3d ahead;
};

/// Two features: what they are, and where their vertices may be. Of a plane B has one vertex, which stands on it.
struct MovingPair {
  reference::PairKind kind = reference::PairKind::VertexTriangle;
  std::vector<MotionSet> a, b;
  double radius = 0;  // of a sphere or capsule [m]
  Vec3d normal;       // of a plane
};

/// n, from B to A, and d, for vertices of A and then of B at these places.
inline reference::Gap gap_at(const MovingPair& pair, const std::vector<Vec3d>& at) {
  using reference::PairKind;
  switch (pair.kind) {
    case PairKind::VertexPlane:
      return reference::plane_gap(at[0], at[1], pair.normal);
    case PairKind::VertexBall:
    case PairKind::VertexCapsule:
      return reference::gap_of(reference::closest_on_segment(at[0], at[1], at[2]).offset, pair.radius);
    case PairKind::EdgeEdge:
    case PairKind::EdgeObjectEdge:
      return reference::gap_of(reference::closest_segments(at[0], at[1], at[2], at[3]).offset, pair.radius);
    default:
      return reference::gap_of(reference::closest_on_triangle(at[0], at[1], at[2], at[3]).offset,
                               pair.radius);
  }
}
inline std::vector<Vec3d> start_of(const MovingPair& pair) {
  std::vector<Vec3d> at;
  for (const auto* side : {&pair.a, &pair.b})
    for (const MotionSet& set : *side) at.push_back(set.place);
  return at;
}

/// By how much the sets of both sides may lessen a distance along n, from B to A [m].
struct Nearing {
  double slack = 0;  // whatever n is
  double ahead = 0;
};
inline Nearing nearing(const MovingPair& pair, const Vec3d& n) {
  double slack_a = 0, slack_b = 0, ahead_a = 0, ahead_b = 0;
  for (const MotionSet& set : pair.a) {
    slack_a = std::max(slack_a, set.slack);
    ahead_a = std::max(ahead_a, -dot(n, set.ahead));
  }
  for (const MotionSet& set : pair.b) {
    slack_b = std::max(slack_b, set.slack);
    ahead_b = std::max(ahead_b, dot(n, set.ahead));
  }
  return {slack_a + slack_b, ahead_a + ahead_b};
}
/// The farthest that any vertex of either side goes ahead, summed over the sides [m].
inline double farthest_ahead(const MovingPair& pair) {
  double sum = 0;
  for (const auto* side : {&pair.a, &pair.b}) {
    double most = 0;
    for (const MotionSet& set : *side) most = std::max(most, length(set.ahead));
    sum += most;
  }
  return sum;
}
/// The law: whether a search lists the pair.
inline bool may_come(const MovingPair& pair, double thickness) {
  const reference::Gap gap = gap_at(pair, start_of(pair));
  const Nearing may = nearing(pair, gap.direction);
  return gap.distance < thickness + may.slack + may.ahead;
}

/// Whether the boxes of all places of both sides come within the thickness: if not, a search may leave the pair
/// out. It does so where the boxes of their triangles do not meet, which are larger.
inline bool boxes_meet(const MovingPair& pair, double thickness) {
  if (pair.kind == reference::PairKind::VertexPlane) return true;
  std::array<Vec3d, 2> low, high;
  for (const std::size_t side : {0U, 1U}) {
    const std::vector<MotionSet>& sets = side == 0 ? pair.a : pair.b;
    double slack = 0;
    low[side] = high[side] = sets[0].place;
    for (const MotionSet& set : sets) {
      slack = std::max(slack, set.slack);
      for (const Vec3d& p : {set.place, set.place + set.ahead}) {
        low[side] = min(low[side], p);
        high[side] = max(high[side], p);
      }
    }
    low[side] -= Vec3d{slack, slack, slack};
    high[side] += Vec3d{slack, slack, slack};
  }
  const double room = thickness + pair.radius;
  for (int axis = 0; axis < 3; ++axis)
    if (low[0][axis] - high[1][axis] > room || low[1][axis] - high[0][axis] > room) return false;
  return true;
}

inline Vec3d random_direction(Random& random) {
  for (;;) {
    const Vec3d v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const double size = length(v);
    if (size > 0.01 && size < 1) return v / size;
  }
}

/// A place of the set. Half of them lie on its rim, as far toward `goal` as may be: what brings features together.
inline Vec3d place_in(const MotionSet& set, const Vec3d& goal, Random& random) {
  const bool rim = random.below(2) == 0;
  double part = random.uniform(0, 1);
  if (rim) part = random.below(3) == 0 ? 0.0 : 1.0;
  const Vec3d on_way = set.place + part * set.ahead;
  const Vec3d toward = goal - on_way;
  const double size = length(toward);
  if (rim && size > 0 && random.below(4) != 0) return on_way + (std::min(set.slack, size) / size) * toward;
  return on_way + (rim ? set.slack : set.slack * std::cbrt(random.uniform(0, 1))) * random_direction(random);
}

/// The least gap on a random motion of the vertices within their sets, straight on from a place to the next, each
/// at its own time [m].
inline double least_gap_on_motions(const MovingPair& pair, std::uint32_t motions, Random& random) {
  std::vector<const MotionSet*> sets;
  for (const auto* side : {&pair.a, &pair.b})
    for (const MotionSet& set : *side) sets.push_back(&set);
  std::vector<Vec3d> from = start_of(pair), to(sets.size()), at(sets.size());
  double least = gap_at(pair, from).distance;
  for (std::uint32_t motion = 0; motion < motions; ++motion) {
    // A vertex aims at one of the other side: where it is, or where its way leads.
    for (std::size_t v = 0; v < sets.size(); ++v) {
      const auto& others = v < pair.a.size() ? pair.b : pair.a;
      const MotionSet& other = others[random.below(static_cast<std::uint32_t>(others.size()))];
      to[v] = place_in(*sets[v], other.place + (random.below(2) == 0 ? 1.0 : 0.0) * other.ahead, random);
    }
    for (const double part : {0.35, 0.7, 1.0}) {
      for (std::size_t v = 0; v < sets.size(); ++v) at[v] = from[v] + part * (to[v] - from[v]);
      least = std::min(least, gap_at(pair, at).distance);
    }
    from = to;
  }
  return least;
}

}  // namespace weft
