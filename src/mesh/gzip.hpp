// Gzip data, unpacked with a bound.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/result.hpp"

namespace weft::mesh {

/// Meshes shrink 3 to 20 times; gzip can shrink zeros 1032 times, which is a bomb and not a mesh.
constexpr std::uint64_t kMaxGzipRatio = 100;
constexpr std::uint64_t kMaxMeshBytes = std::uint64_t{1} << 30U;  // of a mesh file, packed or not

bool is_gzip(std::span<const std::byte> bytes);

/// The unpacked bytes of all members.
/// Errors  Input: broken or truncated data, or an unpacked size over kMaxMeshBytes or kMaxGzipRatio times
///         the packed size; the size is known before any of it is allocated.
Result<std::vector<std::byte>> gunzip(std::span<const std::byte> bytes);

}  // namespace weft::mesh
