// A running scene as bytes, to go on from later: in another process, on another day.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "model/sewn.hpp"
#include "model/tears.hpp"
#include "sim/grabs.hpp"
#include "sim/snapshot.hpp"
#include "weft/totals.hpp"

namespace weft::sim {

struct SavedState {
  std::string build,
      adapter;              // of weft, and the GPU's name, that it comes from: others may end in other bits
  std::uint64_t scene = 0;  // sim::scene_hash
  Snapshot snapshot;
  std::vector<Grabbed> grabs;  // by the host's hand
  weft::Totals totals;         // of the frames up to then
  Tears tears;                 // of its cloth
  Sewing sewing;               // of its cloth
};

/// The bytes, little-endian: "weftsave"; the version, u32; 0, u32; the number of all bytes, u64; XXH3-64 of those that
/// follow, u64; then the members in the order of this header's, each list after its length.
std::vector<std::byte> write_saved_state(const SavedState& state);

/// Errors  Input: not such bytes, of another version, cut off, damaged; a number is not finite. Memory is bounded by
///         the number of bytes.
Result<SavedState> read_saved_state(std::span<const std::byte> bytes);

/// "by BUILD on ADAPTER", as far as a state comes from another than these, so that bits may differ; "": from both.
std::string other_origin(const SavedState& state, const std::string& build, const std::string& adapter);

/// The most bytes that a state of so many nodes has, of so many facets that keep bends, and of so many triangles of
/// cloth that can tear: three nodes each, where all have parted.
std::uint64_t most_saved_bytes(std::uint64_t nodes, std::uint64_t facets, std::uint64_t tearing_triangles);

}  // namespace weft::sim
