#pragma once

#include <cstdint>
#include <vector>

#include "base/result.hpp"
#include "element/spring/spring_kinds.hpp"
#include "mesh/adjacency.hpp"

namespace weft {

inline constexpr std::uint32_t kNeighbourKinds = 16;  // these three: src/element/spring/neighbour.wgsl
inline constexpr std::uint32_t kNeighbourNodeBits = 28;
inline constexpr std::uint32_t kSlice = 32;

/// One spring as one of its nodes sees it. Mirror: src/element/spring/neighbour.wgsl.
struct Neighbour {
  std::uint32_t node_and_kind = 0;
  float rest_length = 0;  // [m]
};
static_assert(sizeof(Neighbour) == 8);

/// Where each slice of kSlice rows begins, if its rows have as many entries each as the longest, and where the last one
/// ends. Errors  Limit: more than 2^32 entries.
Result<std::vector<std::uint32_t>> slice_starts(const mesh::Adjacency& rows);

/// The springs of nodes first … first + count - 1 in slices of kSlice nodes: entry k of node first + i is
/// entries[slices[i / kSlice] + k * kSlice + i % kSlice], in the order of the springs. Nodes with fewer
/// springs than the slice's most have a spring to themselves of length 0, which pulls nowhere.
struct Neighbours {
  std::vector<std::uint32_t> slices;  // one more than there are slices
  std::vector<Neighbour> entries;
  std::vector<SpringKind> kinds;  // at most kNeighbourKinds
};

/// The springs of one cloth, which has at most six kinds, and their incidence. Errors  Limit: more than 2^28 nodes in
/// the scene, or more than 2^32 entries.
Result<Neighbours> build_neighbours(const Springs& springs, const mesh::Adjacency& incidence,
                                    std::uint32_t first);

}  // namespace weft
