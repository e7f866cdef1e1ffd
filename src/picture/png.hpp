#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "picture/image.hpp"

namespace weft::picture {

/// The bytes of a PNG file: without an alpha channel where every pixel is opaque.
/// Errors  OutOfMemory.
Result<std::vector<std::byte>> encode_png(const Image& image);

/// Writes a picture so that it is there whole or not at all.
/// Errors  Failure: the place cannot be written.
Result<void> write_png(const std::string& path, const Image& image);

}  // namespace weft::picture
