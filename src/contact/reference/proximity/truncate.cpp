#include "contact/reference/proximity/truncate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "contact/reference/proximity/may_meet.hpp"
#include "contact/reference/proximity/separate.hpp"
#include "contact/rules/contact_law.hpp"

namespace weft::reference {
namespace {

/// In which cloth is held back; in the last one the substep ends before its time, or all of it is held.
constexpr int kRounds = 3;
/// In which, after the first of those, ways are shortened for the edges between them.
/// Mirror: contact/proximity/round_kernel.hpp.
constexpr int kShortenings = 6;
/// An edge that is no longer than this part of what it may be stays as it is.
constexpr double kBeyondLimit = 1.001;

/// How much of a way takes a vertex past no plane, by how far it is on its side at the start and would be at the end.
double part_before(double at_start, double at_end) {
  if (at_end >= 0) return 1;
  if (at_start > 0) return at_start / (at_start - at_end);
  return at_end < at_start ? 0 : 1;
}

/// How much of a way an edge's end may go that makes it no longer than `longest`, if it is `begin` without that way;
/// where no part does, the one that makes it shortest.
double part_within(const Vec3d& begin, const Vec3d& way, double longest) {
  const double a = dot(way, way), b = dot(begin, way);
  const double root = std::max(0.0, b * b - a * (dot(begin, begin) - longest * longest));
  return std::clamp((std::sqrt(root) - b) / a, 0.0, 1.0);
}

class Truncation {
 public:
  Truncation(std::span<const SolidPlane> planes, std::span<const ClothPair> pairs, const SubstepWays& ways)
      : planes_(planes),
        pairs_(pairs),
        ways_(ways),
        changed_(ways.end.size()),
        held_(ways.end.size()),
        shortened_by_cloth_(ways.end.size()),
        lost_(ways.end.size()),
        lists_(ways.end.size()) {
    for (std::size_t p = 0; p < pairs.size(); ++p)
      for (std::uint32_t k = 0; k < pairs[p].count_a + pairs[p].count_b; ++k)
        lists_[pairs[p].nodes[k]].push_back(static_cast<std::uint32_t>(p));
  }

  void before_solids(double reach) {
    std::vector<std::vector<const SolidPlane*>> planes(ways_.end.size());
    for (const SolidPlane& plane : planes_) planes[plane.node].push_back(&plane);
    for (std::size_t node = 0; node < planes.size(); ++node) {
      if (ways_.inverse_mass[node] == 0) continue;
      end_within(reach, node);
      const Vec3d wanted = ways_.end[node];
      leave_planes(planes[node], node, false);
      const Vec3d taken = wanted - ways_.end[node];
      if (length(taken) > kStoppedPart * length(wanted - ways_.start[node])) lost_[node] += taken;
      end_before(planes[node], node);
      leave_planes(planes[node], node, true);
    }
  }

  /// Separates the pairs that may meet on the way. Whether there are any.
  bool separate_meeting(double reach) {
    const auto end = [&](std::uint32_t node) { return ways_.end[node]; };
    const auto end_by_speed = [&](std::uint32_t node) {
      return ways_.start[node] + ways_.dt * ways_.velocity[node];
    };
    struct Meeting {
      ClothPair pair;
      std::array<double, 4> shifts{};  // by whole masses [m]
    };
    std::vector<Meeting> all;
    std::vector<double> shares(held_.size(), 0);  // pairs that move the node, and share its mass
    const auto count = [&](const ClothPair& pair) {
      const BothSides sides = sides_of(pair, end);
      all.push_back({pair, separated(sides, pair.gap)});
      for (std::uint32_t k = 0; k < pair.count_a + pair.count_b; ++k)
        if (all.back().shifts[k] != 0) ++shares[pair.nodes[k]];
    };
    for (const ClothPair& pair : pairs_)
      if (!pair.tangled && !pair.of_two_bodies && may_meet(pair, ways_.start, ways_.end)) count(pair);
    for (const LimitedEdge& edge : ways_.edges)
      if (const std::optional<ClothPair> ends = too_long(edge)) count(*ends);
    std::vector<Vec3d> move(held_.size()), change(held_.size());
    const auto give = [&](const Meeting& meeting, const auto& place, std::vector<Vec3d>& sums) {
      const ClothPair& pair = meeting.pair;
      BothSides sides = sides_of(pair, place);
      if (sides.apart() >= pair.gap) return;
      for (std::uint32_t k = 0; k < pair.count_a + pair.count_b; ++k)  // no more than it has counted
        sides.mass[k] = meeting.shifts[k] == 0 ? 0 : sides.mass[k] / shares[pair.nodes[k]];
      const std::array<double, 4> shifts = separated(sides, pair.gap);
      for (std::uint32_t k = 0; k < pair.count_a + pair.count_b; ++k)
        if (shifts[k] != 0) sums[pair.nodes[k]] += (shifts[k] / shares[pair.nodes[k]]) * pair.normal;
    };
    for (const Meeting& meeting : all) {
      give(meeting, end, move);
      give(meeting, end_by_speed, change);
    }
    move_ends(reach, move, change);
    met_ = met_ || !all.empty();
    return !all.empty();
  }

  /// Marks the vertices of pairs that may meet on the way, but for pairs that end before their planes, or are
  /// of two bodies.
  bool find_meeting() {
    part_ = 1;
    bool any = false;
    for (const ClothPair& pair : pairs_) {
      bool all_held = true;
      for (std::uint32_t k = 0; k < pair.count_a + pair.count_b; ++k)
        all_held = all_held && (held_[pair.nodes[k]] || ways_.inverse_mass[pair.nodes[k]] == 0);
      if (all_held || !may_meet(pair, ways_.start, ways_.end)) continue;
      any = true;
      const double then = sides_of(pair, [&](std::uint32_t node) { return ways_.end[node]; }).apart();
      const double least = std::min(0.5 * std::max(pair.gap, pair.margin), pair.apart);
      if (then < least) part_ = std::min(part_, std::clamp((pair.gap - least) / (pair.gap - then), 0.0, 1.0));
      if (pair.of_two_bodies) continue;
      for (std::uint32_t k = 0; k < pair.count_a + pair.count_b; ++k) marked_.push_back(pair.nodes[k]);
    }
    met_ = met_ || any;
    return any;
  }
  void hold_marked() {
    for (const std::uint32_t node : marked_) hold(node);
    marked_.clear();
  }
  /// Ends the substep before its time, when none of the pairs found may have met: equation (6h). False, and nothing
  /// changed, where that takes too much.
  bool end_before_time() {
    const auto delay = static_cast<std::uint64_t>(std::ceil(1e6 * ways_.dt * (1 - part_)));
    if (part_ == 0 || delay > ways_.most_delay) return false;
    for (std::size_t node = 0; node < held_.size(); ++node) {
      if (ways_.inverse_mass[node] == 0) continue;
      ways_.end[node] = ways_.start[node] + part_ * (ways_.end[node] - ways_.start[node]);
      ways_.velocity[node] =
          ways_.velocity_before[node] + part_ * (ways_.velocity[node] - ways_.velocity_before[node]);
    }
    delay_ = delay;
    whole_part_ = part_;
    return true;
  }
  void hold_all() {
    for (std::size_t node = 0; node < held_.size(); ++node)
      if (!lists_[node].empty()) hold(node);
  }

  /// Of edges that would be stretched since the way of an end was shortened, by more than that has paid for, shortens
  /// the way of that end which goes farther, but behind no obstacle's plane: equation (6i). Whether there are any.
  bool shorten_for_edges() {
    std::vector<double> part(ways_.end.size(), 1);
    const auto far = [&](std::uint32_t node) {  // what the scene moves goes its way
      const Vec3d way = ways_.end[node] - ways_.start[node];
      return ways_.inverse_mass[node] == 0 ? -1 : dot(way, way);
    };
    bool any = false;
    for (const auto& [a, b] : ways_.yielding) {
      if (!changed_[a] && !changed_[b]) continue;
      const Vec3d end = ways_.end[b] - ways_.end[a];
      const double paid =
          std::min(1.0, ways_.yielding_time / ways_.dt) * std::max(length(lost_[a]), length(lost_[b]));
      const double longest =
          std::max(length(ways_.start[b] - ways_.start[a]), length(end + lost_[b] - lost_[a])) + paid;
      if (length(end) <= kBeyondLimit * longest) continue;
      any = true;
      const auto shorten_one = [&](std::uint32_t one, std::uint32_t other) {
        if (far(one) < far(other)) return;
        const double most =
            part_within(ways_.start[one] - ways_.end[other], ways_.end[one] - ways_.start[one], longest);
        part[one] = std::min(part[one], most);
      };
      shorten_one(a, b);
      shorten_one(b, a);
    }
    if (!any) return false;
    std::vector<double> before(part.size(), 1);  // planes, of the way back
    for (const SolidPlane& plane : planes_) {
      const std::uint32_t node = plane.node;
      const Vec3d way = ways_.end[node] - ways_.start[node];
      const auto inside = [&](const Vec3d& place) { return dot(plane.normal, place) - plane.offset; };
      before[node] = std::min(
          before[node], part_before(inside(ways_.end[node]), inside(ways_.start[node] + part[node] * way)));
    }
    for (std::size_t node = 0; node < part.size(); ++node) shorten(node, 1 - (1 - part[node]) * before[node]);
    met_ = true;
    return true;
  }

  Truncated count() const {
    std::vector<bool> driven(held_.size());
    for (const SolidPlane& plane : planes_)
      if (shortened_by_cloth_[plane.node] && dot(plane.normal, ways_.end[plane.node]) < plane.offset - 1e-12)
        driven[plane.node] = true;
    return {static_cast<std::uint64_t>(std::count(changed_.begin(), changed_.end(), true)),
            static_cast<std::uint64_t>(std::count(driven.begin(), driven.end(), true)),
            delay_,
            whole_part_,
            taken_,
            met_};
  }

 private:
  void end_within(double reach, std::size_t node) {
    const double far = length(ways_.end[node] - ways_.start[node]);
    if (far > reach) shorten(node, reach / far);
  }
  double beyond(const SolidPlane& plane, const Vec3d& place) const {
    return plane.offset - dot(plane.normal, place);
  }
  /// Takes the end of a way out of planes, the deepest first; out of those before cloth too, or not.
  void leave_planes(std::span<const SolidPlane* const> planes, std::size_t node, bool of_cloth) {
    for (std::uint32_t round = 0; round < kPlaneRounds; ++round) {
      const SolidPlane* deepest = nullptr;
      double depth = 0;
      for (const SolidPlane* plane : planes) {
        const double one = beyond(*plane, ways_.end[node]);
        if ((of_cloth || !plane->of_cloth) && one > depth) {
          deepest = plane;
          depth = one;
        }
      }
      if (deepest == nullptr) return;
      const SolidPlane& plane = *deepest;
      changed_[node] = true;
      Vec3d& velocity = ways_.velocity[node];
      const Vec3d before = velocity;
      ways_.end[node] += depth * plane.normal;
      velocity += std::clamp(plane.speed - dot(plane.normal, velocity), 0.0, depth / ways_.dt) * plane.normal;
      take(plane.collider, node, before);
    }
  }
  /// Ends a way before the first plane that it would pass.
  void end_before(std::span<const SolidPlane* const> planes, std::size_t node) {
    double part = 1;
    std::size_t stopped_by = kNoCollider;
    for (const SolidPlane* plane : planes) {
      const double at_start = -beyond(*plane, ways_.start[node]), past = beyond(*plane, ways_.end[node]);
      if (!(at_start > 0) || !(past > kBeyondPlane * plane->thickness)) continue;
      const double before = part_before(at_start, -past);
      if (before < part) stopped_by = plane->collider;
      part = std::min(part, before);
    }
    if (part == 1) return;
    const Vec3d before = ways_.velocity[node];
    shorten(node, part);
    take(stopped_by, node, before);
  }

  /// The ends of an edge that would end longer than its strain limit, and than it begins, as sides that come no
  /// farther apart: equation (6f).
  std::optional<ClothPair> too_long(const LimitedEdge& edge) const {
    const double longest =
        std::max(static_cast<double>(edge.longest), length(ways_.start[edge.b] - ways_.start[edge.a]));
    const Vec3d end = ways_.end[edge.b] - ways_.end[edge.a];
    if (length(end) <= kBeyondLimit * longest) return std::nullopt;
    ClothPair ends{1, 1, {edge.a, edge.b}, (1 / length(end)) * end};
    ends.gap = -longest;
    return ends;
  }

  template <class Place>
  BothSides sides_of(const ClothPair& pair, const Place& place) const {
    BothSides sides{pair.count_a, pair.count_b};
    for (std::uint32_t k = 0; k < pair.count_a + pair.count_b; ++k) {
      const double inverse_mass = ways_.inverse_mass[pair.nodes[k]];
      sides.along[k] = dot(pair.normal, place(pair.nodes[k]));
      sides.stays[k] = inverse_mass == 0;
      sides.mass[k] = inverse_mass == 0 ? 0 : 1 / inverse_mass;
    }
    return sides;
  }

  /// Moves the ends of ways, but not beyond the reach, nor past the plane of an obstacle; velocities by as much.
  void move_ends(double reach, std::span<const Vec3d> move, std::span<const Vec3d> change) {
    std::vector<double> part(held_.size(), 1);
    for (std::size_t node = 0; node < part.size(); ++node)
      if (length(ways_.end[node] + move[node] - ways_.start[node]) > reach) part[node] = 0;
    for (const SolidPlane& plane : planes_) {
      const auto inside = [&](const Vec3d& place) { return dot(plane.normal, place) - plane.offset; };
      const Vec3d& end = ways_.end[plane.node];
      part[plane.node] = std::min(part[plane.node], part_before(inside(end), inside(end + move[plane.node])));
    }
    for (std::size_t node = 0; node < part.size(); ++node) {
      ways_.end[node] += part[node] * move[node];
      ways_.velocity[node] += (part[node] / ways_.dt) * change[node];
    }
  }

  /// A rigid body gets what its plane has taken from a node's velocity.
  void take(std::size_t collider, std::size_t node, const Vec3d& before) {
    if (collider == kNoCollider || ways_.velocity[node] == before) return;
    taken_.push_back({collider, static_cast<std::uint32_t>(node),
                      (before - ways_.velocity[node]) / ways_.inverse_mass[node]});
  }

  void shorten(std::size_t node, double part) {
    if (ways_.inverse_mass[node] == 0 || part == 1) return;
    const Vec3d way = part * (ways_.end[node] - ways_.start[node]);
    lost_[node] += ways_.end[node] - ways_.start[node] - way;
    ways_.end[node] = ways_.start[node] + way;
    ways_.velocity[node] = part * ways_.velocity[node];
    changed_[node] = true;
  }

  /// Ends a vertex's way before the planes half way between it and all other cloth.
  void hold(std::size_t node) {
    if (held_[node]) return;
    held_[node] = true;
    double part = 1;
    for (const std::uint32_t p : lists_[node]) {
      const ClothPair& pair = pairs_[p];
      const bool on_a = std::find(pair.nodes.begin(), pair.nodes.begin() + pair.count_a, node) !=
                        pair.nodes.begin() + pair.count_a;
      const double side = on_a ? 1 : -1;
      const auto inside = [&](const Vec3d& place) {
        return side * (dot(pair.normal, place) - pair.middle) - pair.margin;
      };
      part = std::min(part, part_before(inside(ways_.start[node]), inside(ways_.end[node])));
    }
    if (part == 1) return;
    shortened_by_cloth_[node] = true;
    shorten(node, part);
  }

  std::span<const SolidPlane> planes_;
  std::span<const ClothPair> pairs_;
  const SubstepWays& ways_;
  std::vector<bool> changed_, held_, shortened_by_cloth_;
  std::vector<Vec3d> lost_;  // of each way, what was taken from it [m]
  double part_ = 1;          // of the substep: until then no pair found in this round may have met
  double whole_part_ = 1;
  std::vector<Truncated::Taken> taken_;
  std::uint64_t delay_ = 0;  // [µs]
  bool met_ = false;
  std::vector<std::uint32_t> marked_;
  std::vector<std::vector<std::uint32_t>> lists_;
};

}  // namespace

bool separate(std::span<const SolidPlane> planes, std::span<const ClothPair> pairs, double reach,
              const SubstepWays& ways) {
  return Truncation(planes, pairs, ways).separate_meeting(reach);
}

Truncated truncate(std::span<const SolidPlane> planes, std::span<const ClothPair> pairs, double reach,
                   const SubstepWays& ways) {
  Truncation truncation(planes, pairs, ways);
  truncation.before_solids(reach);
  for (std::uint32_t round = 0; round < ways.separations; ++round)
    if (!truncation.separate_meeting(reach)) break;
  if (truncation.find_meeting()) truncation.hold_marked();
  for (int round = 0; round < kShortenings; ++round)
    if (!truncation.shorten_for_edges()) break;
  for (int round = 2; truncation.find_meeting(); ++round) {
    if (round == kRounds) {
      if (!truncation.end_before_time()) truncation.hold_all();
      break;
    }
    truncation.hold_marked();
  }
  return truncation.count();
}

}  // namespace weft::reference
