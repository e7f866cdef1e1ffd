// Separates cloth that would meet, and truncates the motion of vertices where they would pass something, in double.
// Source: docs/contact.md, No pass-through.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "mesh/adjacency.hpp"
#include "model/limited_edges.hpp"

namespace weft::reference {

inline constexpr std::size_t kNoCollider = static_cast<std::size_t>(-1);

/// The side of a plane of an obstacle that a vertex must end on: normal . x >= offset. The obstacle's feature ends
/// there, so the plane may come towards the vertex.
struct SolidPlane {
  std::uint32_t node = 0;
  Vec3d normal;                        // unit
  double offset = 0;                   // [m]
  double speed = 0;                    // of the obstacle along the normal [m/s]
  std::size_t collider = kNoCollider;  // where it is a rigid body, which
  double thickness = 0;                // that is kept from the obstacle [m]
  bool of_cloth = false;               // which the scene pins or moves: a way ends there, and does not go on
};

/// Two sides of cloth, and the direction that separates them at the start of a substep.
struct ClothPair {
  std::uint32_t count_a = 0, count_b = 0;
  std::array<std::uint32_t, 4> nodes{};  // of A, then of B
  Vec3d normal;                          // unit, from B to A
  double middle = 0;                     // along the normal, half way between the closest points [m]
  double margin = 0;                     // how near to the middle each side may come [m]
  double apart = 0;                      // how far apart along the normal they have to end [m]
  double gap = 0;                        // how far apart they begin [m]
  bool tangled = false;                  // a vertex belongs to a crossing: held back, not separated
  bool of_two_bodies = false;            // of one system: for them the substep ends before its time
};

/// The motion of the vertices in a substep.
struct SubstepWays {
  std::span<const Vec3d> start;          // [m]
  std::span<const double> inverse_mass;  // 0: it stays
  std::span<Vec3d> end, velocity;        // [m], [m/s]
  double dt = 1;                         // of the substep [s]
  std::uint32_t separations = 0;  // rounds in which pairs of cloth that may meet are separated, at most
  std::span<const LimitedEdge> edges = {};      // kept within their strain limit in the same rounds
  std::uint64_t most_delay = 0;                 // how much sooner it may end for all [µs]
  std::span<const Vec3d> velocity_before = {};  // at the start, if it may [m/s]
  std::span<const mesh::Edge> yielding = {};    // not to be stretched beside ways that were held back
  double yielding_time = 0;                     // of these, YieldingEdges::time [s]
};

struct Truncated {
  std::uint64_t vertices = 0;  // whose way is another than the one that they came with, but for blows
  std::uint64_t driven =
      0;  // of these, left beyond the plane of an obstacle that drives them into other cloth
  std::uint64_t delay = 0;  // how much sooner the substep has ended for all [µs]
  double part = 1;          // of the substep that has passed then
  /// What the planes of rigid bodies have taken from nodes.
  struct Taken {
    std::size_t collider = 0;
    std::uint32_t node = 0;
    Vec3d impulse;  // that the body gets [N·s]
  };
  std::vector<Taken> taken = {};
  bool met = false;  // whether there were pairs of cloth that might have met, or edges beyond their limit
};

/// One round of separation: equation (6d). Whether there was anything that may meet.
bool separate(std::span<const SolidPlane> planes, std::span<const ClothPair> pairs, double reach,
              const SubstepWays& ways);

/// Takes the end of each way out of the planes of obstacles, or ends the way before them, and no further than `reach`
/// [m]; an obstacle that has come past a vertex takes it along. Then separates pairs of cloth that may meet, equation
/// (6d), and shortens ways until none can have met, equations (6) and (6h).
Truncated truncate(std::span<const SolidPlane> planes, std::span<const ClothPair> pairs, double reach,
                   const SubstepWays& ways);

}  // namespace weft::reference
