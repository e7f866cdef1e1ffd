// The pairs of features that may touch, as proximity contact lists them for a solver. Equations:
// docs/contact.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "contact/rules/solved_contact.hpp"
#include "gpu/buffer.hpp"
#include "model/model.hpp"

namespace weft {

/// Mirror of ListedPair in src/state/contact.wgsl.
struct ListedPair {
  std::array<std::uint32_t, 4> ids{};    // side A first; flags in their upper bits
  std::array<std::uint32_t, 4> words{};  // its record's number, or its thickness; friction; gap
};
static_assert(sizeof(ListedPair) == 32);

/// The record of a pair that is near. Mirror of Contact in src/state/contact.wgsl.
struct Contact {
  std::array<std::uint32_t, 4> ids{};   // of the listed pair
  std::array<std::uint32_t, 4> next{};  // links to its vertices' other records
  Vec4f normal;                         // from B to A; w: the gap [m]
  Vec4f place;                          // s, t; two places along the normal [m]
  Vec4f surface;                        // the collider's share of the relative velocity [m/s]; w: friction
  Vec4f force;                          // on side A [N]; w: the least normal velocity [m/s]
  float urgency = 0;
  std::uint32_t solid = 0;      // 1: side A goes its way whatever comes; 2: side B; 0: neither; or kUntangles
  std::uint32_t near = 0;       // 1: it acts, or would but for its cones, or has a plane that must hold
  std::uint32_t other_end = 0;  // of a crossing: the id of the edge's other end; else as in the kernel
  float thickness = 0;          // the distance that it keeps [m]
  float solid_speed = 0;        // of a solid side, toward the other [m/s]
  float begun = 0;              // the normal part of the force before it went ahead [N]
  std::uint32_t held = 0;       // 1: the solver's matrix has answered it; 2: the same of cloth with cloth
};
static_assert(sizeof(Contact) == 128 && offsetof(Contact, normal) == 32 && offsetof(Contact, force) == 80);

/// How an implicit substep holds a near pair of one cloth apart. Mirror of PairHold in src/state/pair_holds.wgsl.
struct PairHold {
  std::array<std::uint32_t, 4> ids{};  // of the listed pair
  Vec4f normal;                        // n; w: k [N/m]; 0: it is not held
  Vec4f along;                         // the force of friction [N]; w: k_t [N/m]
  Vec4f force;                         // along n [N]; g and z [m]; friction
  Vec4f place;                         // s, t; mobility [1/kg]; stiffness of the sides [N/m]
  Vec4f start;                         // [m]; w: the lack that the velocities would leave [m]
};
static_assert(sizeof(PairHold) == 96);

inline constexpr std::uint32_t kColliderPoint = 0x80000000U, kPairFlag = 0x40000000U, kIdBits = 0x3fffffffU;
inline constexpr std::uint32_t kCrossingFlag = 0x40000000U, kUntangles = 4;
inline constexpr std::uint32_t kHasRecord = 0x80000000U;             // of ListedPair::words[0]
inline constexpr std::uint32_t kVertexWords = 16, kTangledWord = 4;  // of ContactPairs::vertex_contacts
inline constexpr std::uint32_t kPairSumWords = 8;                    // of ContactPairs::pair_sums
inline constexpr std::uint32_t kHoldWords = 4, kPressWords = 20;     // of ContactPairs::presses
inline constexpr std::uint32_t kHeader = 8, kKeptRoomWord = 2, kKeptWords = 8;  // of ContactPairs::kept

/// The capacities of the lists of proximity contact.
struct ContactRoom {
  std::uint32_t pairs = 0;       // of features
  std::uint32_t near = 0;        // of these, the ones that are near, and have records
  std::uint32_t candidates = 0;  // pairs of triangles that may hold some

  bool operator==(const ContactRoom&) const = default;
};

/// Room for lists that were too short: half as much again as was wanted, since the next frames may need more,
/// but no more than a binding of `most_bytes` may have where what is wanted fits in it.
ContactRoom grown(const ContactRoom& room, const ContactRoom& wanted, std::uint64_t most_bytes);

/// A pair is listed once; while it is near, it has a record, and each of its cloth vertices has a link to that. Neither
/// pairs nor records have an order that lasts from run to run, so sums over them are of integers.
struct ContactPairs {
  ContactRoom room;
  gpu::Buffer<Vec4f> predicted;                // 3 * vertex_count: velocities that the solver predicts [m/s];
                                               // then src/contact/proximity/reach.wgsl [m]
  gpu::Buffer<ListedPair> listed;              // room.pairs
  gpu::Buffer<Contact> contacts;               // room.near
  gpu::Buffer<std::uint32_t> vertex_contacts;  // kVertexWords * vertex_count

  /// The forces of acting pairs beyond a search: two lists with room for all near pairs, and a hash table over one of
  /// them (src/contact/proximity/kept_forces.wgsl).
  gpu::Buffer<std::uint32_t> kept;

  /// Of each vertex the force that holds it at obstacles; then the sums over its pairs with obstacles before a substep
  /// is solved (src/contact/proximity/press_sums.wgsl). (kHoldWords + kPressWords) * vertex_count, or none where the
  /// solver needs none.
  gpu::Buffer<std::int32_t> presses;

  /// Where a solver's matrix holds pairs apart: how, one for each record; and sums over a vertex's (kPairSumWords *
  /// vertex_count). Else none.
  gpu::Buffer<PairHold> pair_holds;
  gpu::Buffer<std::uint32_t> pair_sums;

  /// Errors  Limit, OutOfMemory.
  static Result<ContactPairs> create(gpu::Device& device, const Model& model, const ContactRoom& room,
                                     const SolvedContact& solved);
  /// Other room for pairs and records, whose contents are lost; all else stays, also the forces that the last frame's
  /// end has kept. Errors  Limit, OutOfMemory.
  Result<void> make_room(gpu::Device& device, const ContactRoom& wanted);
};

}  // namespace weft
