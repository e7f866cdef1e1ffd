#include "mesh/stl.hpp"

#include <algorithm>
#include <cstring>

#include "mesh/little_endian.hpp"
#include "mesh/merge.hpp"
#include "mesh/text_cursor.hpp"

namespace weft::mesh {
namespace {

constexpr std::uint64_t kHeaderSize = 84;    // 80 of text, 4 of the count
constexpr std::uint64_t kTriangleSize = 50;  // normal, three corners, two bytes of attributes

TriangleMesh merged(std::vector<Vec3f> points) {
  TriangleMesh mesh;
  mesh.triangles.resize(points.size() / 3);
  for (std::uint32_t i = 0; i < points.size(); ++i) mesh.triangles[i / 3][i % 3] = i;
  mesh.positions = std::move(points);
  merge_vertices(mesh);
  return mesh;
}

Vec3f without_negative_zero(const Vec3f& p) { return {p.x + 0.0F, p.y + 0.0F, p.z + 0.0F}; }

Result<TriangleMesh> read_binary(std::span<const std::byte> bytes, std::size_t count) {
  std::vector<Vec3f> points(3 * count);
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto at = static_cast<std::size_t>(kHeaderSize + (i / 3) * kTriangleSize + (1 + i % 3) * sizeof(Vec3f));
    for (int axis = 0; axis < 3; ++axis, at += 4) {
      const std::uint32_t bits = load_little_endian(bytes.subspan(at).first<4>());
      std::memcpy(&points[i][axis], &bits, sizeof bits);
    }
    points[i] = without_negative_zero(points[i]);
  }
  TriangleMesh mesh = merged(std::move(points));
  WEFT_CHECK(check_mesh(mesh));
  return mesh;
}

Result<void> expect(TextCursor& cursor, std::string_view word, std::string_view expected) {
  if (same_word(word, expected)) return {};
  if (word.empty())
    return input_error("Line %zu ends the file where \"%s\" is due.", cursor.line(),
                       quoted(expected).c_str());
  return input_error("Line %zu has \"%s\" where \"%s\" is due.", cursor.line(), quoted(word).c_str(),
                     quoted(expected).c_str());
}

Result<void> expect(TextCursor& cursor, std::string_view expected) {
  return expect(cursor, cursor.next(), expected);
}

// After the word "facet".
Result<void> read_facet(TextCursor& cursor, std::vector<Vec3f>& points) {
  WEFT_CHECK(expect(cursor, "normal"));
  for (int axis = 0; axis < 3; ++axis) cursor.next();  // often wrong, or not a number: the corners decide
  WEFT_CHECK(expect(cursor, "outer"));
  WEFT_CHECK(expect(cursor, "loop"));
  for (int corner = 0; corner < 3; ++corner) {
    WEFT_CHECK(expect(cursor, "vertex"));
    WEFT_TRY(point, read_point(cursor));
    points.push_back(without_negative_zero(point));
  }
  WEFT_CHECK(expect(cursor, "endloop"));
  return expect(cursor, "endfacet");
}

Result<TriangleMesh> read_text(std::span<const std::byte> bytes) {
  TextCursor cursor(bytes, {});
  std::vector<Vec3f> points;
  std::string_view word = cursor.next();
  do {  // a file may hold several solids
    WEFT_CHECK(expect(cursor, word, "solid"));
    cursor.next_line();  // its name
    for (word = cursor.next(); same_word(word, "facet"); word = cursor.next())
      WEFT_CHECK(read_facet(cursor, points));
    WEFT_CHECK(expect(cursor, word, "endsolid"));
    cursor.next_line();
    word = cursor.next();
  } while (!word.empty());
  TriangleMesh mesh = merged(std::move(points));
  WEFT_CHECK(check_mesh(mesh));
  return mesh;
}

bool looks_like_text(std::span<const std::byte> bytes) {
  TextCursor cursor(bytes.first(std::min<std::size_t>(bytes.size(), 512)), {});
  return same_word(cursor.next(), "solid");
}

}  // namespace

Result<TriangleMesh> read_stl(std::span<const std::byte> bytes) {
  if (bytes.size() >= kHeaderSize) {
    const std::uint64_t count = load_little_endian(bytes.subspan<kHeaderSize - 4, 4>());
    if (kHeaderSize + kTriangleSize * count == bytes.size())
      return read_binary(bytes, static_cast<std::size_t>(count));
    if (!looks_like_text(bytes))
      return input_error("The file states %llu triangles, which take %llu bytes, but it has %zu.",
                         static_cast<unsigned long long>(count),
                         static_cast<unsigned long long>(kHeaderSize + kTriangleSize * count), bytes.size());
  }
  return read_text(bytes);
}

}  // namespace weft::mesh
