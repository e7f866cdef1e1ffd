#include "mesh/glb_chunks.hpp"

#include <algorithm>

#include "mesh/little_endian.hpp"

namespace weft::mesh {
namespace {

std::uint32_t word(std::span<const std::byte> bytes, std::size_t at) {
  return load_little_endian(bytes.subspan(at).first<4>());
}

// The parser's sentences repeat the file's bytes, whatever they are.
Error printable(Error error) {
  std::replace_if(
      error.message.begin(), error.message.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return error;
}

}  // namespace

bool begins_as_glb(std::span<const std::byte> bytes) {
  return bytes.size() >= 4 && word(bytes, 0) == kGlbMagic;
}

std::vector<std::byte> glb_before_binary(std::string json, std::uint64_t binary_size) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t before = kGlbHeaderSize + 2 * kGlbChunkHeaderSize + json.size();
  std::vector<std::byte> bytes;
  bytes.reserve(before);
  for (const std::uint64_t number :
       {std::uint64_t{kGlbMagic}, std::uint64_t{kGlbVersion}, before + binary_size,
        std::uint64_t{json.size()}, std::uint64_t{kGlbJsonChunk}})
    append_little_endian(bytes, static_cast<std::uint32_t>(number));
  for (const char c : json) bytes.push_back(static_cast<std::byte>(c));
  append_little_endian(bytes, static_cast<std::uint32_t>(binary_size));
  append_little_endian(bytes, kGlbBinaryChunk);
  return bytes;
}

Result<GlbChunks> split_glb(std::span<const std::byte> bytes) {
  if (bytes.size() < kGlbHeaderSize)
    return input_error("The file has %zu bytes, fewer than the %zu of a GLB header.", bytes.size(),
                       kGlbHeaderSize);
  if (const std::uint32_t magic = word(bytes, 0); magic != kGlbMagic)
    return input_error("The file begins with 0x%08x, not with the 0x%08x of a GLB file.", magic, kGlbMagic);
  if (const std::uint32_t version = word(bytes, 4); version != kGlbVersion)
    return input_error("The file is of version %u of GLB, not %u.", version, kGlbVersion);
  if (const std::uint32_t length = word(bytes, 8); length != bytes.size())
    return input_error("The header states %u bytes, but the file has %zu.", length, bytes.size());

  GlbChunks chunks;
  std::span<const std::byte> json;
  std::size_t at = kGlbHeaderSize;
  for (std::size_t number = 0; at < bytes.size(); ++number) {
    if (bytes.size() - at < kGlbChunkHeaderSize)
      return input_error("The file ends at byte %zu, inside the header of a chunk.", bytes.size());
    const std::uint32_t length = word(bytes, at), type = word(bytes, at + 4);
    at += kGlbChunkHeaderSize;
    if (length > bytes.size() - at)
      return input_error("The chunk at byte %zu states %u bytes, but only %zu follow.",
                         at - kGlbChunkHeaderSize, length, bytes.size() - at);
    const std::span<const std::byte> content = bytes.subspan(at, length);
    if (number == 0 && type != kGlbJsonChunk)
      return input_error("The first chunk has the type 0x%08x, not the 0x%08x of JSON.", type, kGlbJsonChunk);
    if (number == 0) json = content;
    if (number == 1 && type == kGlbBinaryChunk) chunks.binary = content;
    at += length;
  }
  if (json.empty()) return input_error("The file has no JSON chunk.");
  auto parsed = parse_json({reinterpret_cast<const char*>(json.data()), json.size()}, "JSON chunk");
  if (!parsed) return printable(parsed.error());
  chunks.json = std::move(parsed).value();
  return chunks;
}

}  // namespace weft::mesh
