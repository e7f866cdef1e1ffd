// The container of a binary glTF file: what it says, and the bytes that this is about.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/json.hpp"
#include "base/result.hpp"

namespace weft::mesh {

constexpr std::uint32_t kGlbMagic = 0x46546C67;  // "glTF"
constexpr std::uint32_t kGlbVersion = 2;
constexpr std::uint32_t kGlbJsonChunk = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kGlbBinaryChunk = 0x004E4942;  // "BIN"
constexpr std::size_t kGlbHeaderSize = 12;             // bytes: magic, version, length of the file
constexpr std::size_t kGlbChunkHeaderSize = 8;         // bytes: length of the chunk, type

struct GlbChunks {
  Json json;
  std::span<const std::byte> binary;  // empty where there is none
};

/// Whether bytes begin as a GLB file does.
bool begins_as_glb(std::span<const std::byte> bytes);

/// A file up to its binary chunk, whose `binary_size` bytes, a multiple of 4, follow. The JSON is padded.
std::vector<std::byte> glb_before_binary(std::string json, std::uint64_t binary_size);

/// Splits a file and reads its JSON; chunks of other types are passed over.
/// Errors  Input: what is wrong, with the byte, or the line and column of the JSON; the limits of json.hpp.
Result<GlbChunks> split_glb(std::span<const std::byte> bytes);

}  // namespace weft::mesh
