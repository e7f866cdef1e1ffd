// The pairs of features that may touch, as proximity contact lists them for a solver. Equations:
// docs/contact.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "gpu/buffer.hpp"
#include "model/host_model.hpp"

namespace weft {

/// Mirror of Contact in shaders/shared/contact.wgsl.
struct Contact {
  std::array<std::uint32_t, 4> ids{};    // side A first; kColliderPoint and kPairFlag in their upper bits
  std::array<std::uint32_t, 4> slots{};  // of `entries`
  Vec4f normal;                          // from B to A; w: the gap [m]
  Vec4f place;                           // s, t; two places along the normal [m]
  Vec4f surface;                         // the collider's share of the relative velocity [m/s]; w: friction
};
static_assert(sizeof(Contact) == 80 && offsetof(Contact, normal) == 32 && offsetof(Contact, surface) == 64);

inline constexpr std::uint32_t kColliderPoint = 0x80000000U, kPairFlag = 0x40000000U, kIdBits = 0x3fffffffU;
inline constexpr std::uint32_t kVertexWords = 4;   // of ContactPairs::vertex_contacts
inline constexpr std::uint32_t kScanBlock = 1024;  // numbers that a workgroup scans

/// Blocks of a scan of `count` numbers.
constexpr std::uint32_t scan_blocks(std::uint32_t count) { return (count + kScanBlock - 1) / kScanBlock; }

/// A pair is listed once; its entries, one for each cloth vertex in it, stand vertex after vertex, each
/// vertex's in the order of the pairs. So a gather over a vertex's entries has one order, and the same bits
/// in every run.
struct ContactPairs {
  std::uint32_t capacity = 0;                  // pairs
  gpu::Buffer<Vec4f> predicted;                // 2 * vertex_count: velocities that the solver predicts [m/s];
                                               // then where reaches are measured from [m]
  gpu::Buffer<Contact> contacts;               // capacity
  gpu::Buffer<std::uint32_t> entries;          // 4 * capacity
  gpu::Buffer<std::uint32_t> vertex_contacts;  // kVertexWords * vertex_count, blocks, the total

  /// Errors  Limit, OutOfMemory.
  static Result<ContactPairs> create(gpu::Device& device, const HostModel& model, std::uint32_t capacity);
};

}  // namespace weft
