#include "mesh/gzip.hpp"

#include <zlib.h>

#include <algorithm>

namespace weft::mesh {
namespace {

constexpr int kGzipWindow = 15 + 16;  // zlib: the largest window, and gzip headers only

/// A zlib stream that ends with its scope.
struct Inflater {
  z_stream stream{};
  bool ready = inflateInit2(&stream, kGzipWindow) == Z_OK;
  ~Inflater() {
    if (ready) inflateEnd(&stream);
  }
};

unsigned piece(std::size_t size) { return static_cast<unsigned>(std::min<std::size_t>(size, 1U << 30U)); }

// Unpacks all members into `place`. sink(place, made) learns how many bytes were made there and returns where
// the next ones go.
template <class Sink>
Result<void> unpack(std::span<const std::byte> bytes, std::span<Bytef> place, Sink sink) {
  Inflater inflater;
  if (!inflater.ready) return make_error(ErrorKind::OutOfMemory, "The zlib library cannot start.");
  z_stream& stream = inflater.stream;
  std::size_t at = 0;  // bytes handed to zlib
  while (true) {
    if (stream.avail_in == 0) {
      const unsigned size = piece(bytes.size() - at);
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(bytes.data() + at));
      stream.avail_in = size;
      at += size;
    }
    const unsigned room = piece(place.size());
    stream.next_out = place.data();
    stream.avail_out = room;
    const int status = inflate(&stream, Z_NO_FLUSH);
    const std::size_t offset = at - stream.avail_in;
    const unsigned made = room - stream.avail_out;
    if (status != Z_OK && status != Z_STREAM_END) {
      if (status == Z_BUF_ERROR)
        return input_error("The gzip data end at byte %zu, before they are complete.", offset);
      return input_error("The gzip data are broken at byte %zu: %s.", offset,
                         stream.msg != nullptr ? stream.msg : "not gzip");
    }
    WEFT_TRY(next, sink(place, made));
    place = next;
    if (status != Z_STREAM_END) continue;
    if (offset == bytes.size()) return {};
    if (!is_gzip(bytes.subspan(offset)))
      return input_error("The gzip data end at byte %zu, but %zu bytes follow.", offset,
                         bytes.size() - offset);
    inflateReset(&stream);
  }
}

}  // namespace

bool is_gzip(std::span<const std::byte> bytes) {
  return bytes.size() >= 2 && bytes[0] == std::byte{0x1f} && bytes[1] == std::byte{0x8b};
}

// Twice: once to measure, so that a bomb costs no memory, and once into a buffer of the right size.
Result<std::vector<std::byte>> gunzip(std::span<const std::byte> bytes) {
  const std::uint64_t limit = std::min<std::uint64_t>(kMaxMeshBytes, kMaxGzipRatio * bytes.size());
  std::uint64_t size = 0;
  std::vector<Bytef> scratch(std::size_t{1} << 16U);
  WEFT_CHECK(unpack(bytes, scratch, [&](std::span<Bytef> place, unsigned made) -> Result<std::span<Bytef>> {
    size += made;
    if (size > limit)
      return input_error("The %zu bytes of gzip data unpack to more than the limit of %llu bytes.",
                         bytes.size(), static_cast<unsigned long long>(limit));
    return place;
  }));
  // One byte more, so that zlib always has room to see the end of the stream.
  std::vector<std::byte> result(static_cast<std::size_t>(size) + 1);
  const std::span<Bytef> all(reinterpret_cast<Bytef*>(result.data()), result.size());
  WEFT_CHECK(unpack(bytes, all, [](std::span<Bytef> place, unsigned made) -> Result<std::span<Bytef>> {
    return place.subspan(made);
  }));
  result.pop_back();
  return result;
}

}  // namespace weft::mesh
