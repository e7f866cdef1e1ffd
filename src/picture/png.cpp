#include "picture/png.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdlib>

#include "base/file.hpp"

namespace {

/// zlib's fastest level instead of stb's own compressor, which takes several times as long for larger files.
/// The result is freed by stb.
unsigned char* compress_quickly(unsigned char* data, int size, int* compressed_size, int /*quality*/) {
  uLongf length = compressBound(static_cast<uLong>(size));
  auto* bytes = static_cast<unsigned char*>(std::malloc(length));
  if (bytes == nullptr) return nullptr;
  if (compress2(bytes, &length, data, static_cast<uLong>(size), 1) != Z_OK) {
    std::free(bytes);
    return nullptr;
  }
  *compressed_size = static_cast<int>(length);
  return bytes;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS compress_quickly
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace weft::picture {
namespace {

constexpr int kFilterUp =
    2;  // smooth pictures compress well by rows; trying all five filters costs more than it saves

void append(void* context, void* data, int size) {
  auto& bytes = *static_cast<std::vector<std::byte>*>(context);
  const auto* first = static_cast<const std::byte*>(data);
  bytes.insert(bytes.end(), first, first + size);
}

}  // namespace

Result<std::vector<std::byte>> encode_png(const Image& image) {
  const std::size_t pixels = std::size_t{image.width} * image.height;
  bool opaque = true;
  for (std::size_t i = 0; i < pixels && opaque; ++i) opaque = image.rgba[4 * i + 3] == 255;
  std::vector<std::uint8_t> rgb(opaque ? 3 * pixels : 0);
  for (std::size_t i = 0; i < rgb.size() / 3; ++i) std::copy_n(&image.rgba[4 * i], 3, &rgb[3 * i]);
  const int channels = opaque ? 3 : 4;
  const std::uint8_t* data = opaque ? rgb.data() : image.rgba.data();
  const int width = static_cast<int>(image.width), height = static_cast<int>(image.height);
  stbi_write_force_png_filter = kFilterUp;
  std::vector<std::byte> bytes;
  if (stbi_write_png_to_func(append, &bytes, width, height, channels, data, channels * width) == 0)
    return make_error(ErrorKind::OutOfMemory, "A picture of %d x %d pixels cannot be compressed.", width,
                      height);
  return bytes;
}

Result<void> write_png(const std::string& path, const Image& image) {
  WEFT_TRY(bytes, encode_png(image));
  return write_file(path, bytes);
}

}  // namespace weft::picture
