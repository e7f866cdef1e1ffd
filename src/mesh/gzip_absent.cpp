// Where there is no zlib, as in a browser: packed meshes are unpacked before they get here.
#include "mesh/gzip.hpp"

namespace weft::mesh {

bool is_gzip(std::span<const std::byte> bytes) {
  return bytes.size() > 1 && bytes[0] == std::byte{0x1f} && bytes[1] == std::byte{0x8b};
}

Result<std::vector<std::byte>> gunzip(std::span<const std::byte>) {
  return input_error("This build does not unpack gzip data: hand it the unpacked file.");
}

}  // namespace weft::mesh
