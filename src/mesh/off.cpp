#include "mesh/off.hpp"

#include <algorithm>

#include "mesh/number.hpp"
#include "mesh/polygon.hpp"
#include "mesh/text_cursor.hpp"

namespace weft::mesh {
namespace {

constexpr TextCursor::Rules kOffRules{.comments = true, .continuations = false};

struct OffCounts {
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
};

bool is_keyword(std::string_view word) {
  for (const std::string_view prefix : {"ST", "C", "N"})
    if (word.substr(0, prefix.size()) == prefix) word.remove_prefix(prefix.size());
  return word == "OFF";
}

Result<std::uint64_t> read_count(TextCursor& cursor, std::string_view word, const char* what) {
  const auto number = parse_integer(word);
  if (!number || *number < 0)
    return input_error("Line %zu has \"%s\" where the number of %s is due.", cursor.line(),
                       quoted(word).c_str(), what);
  return static_cast<std::uint64_t>(*number);
}

// A line of n numbers takes 2 n - 1 bytes and its end; no count is believed that the bytes cannot hold.
Result<void> check_count(const TextCursor& cursor, std::uint64_t count, std::uint64_t least_size,
                         const char* what) {
  if (count <= (cursor.remaining() + 1) / least_size) return {};
  return input_error("Line %zu announces %llu %s, more than the %zu bytes after it can hold.", cursor.line(),
                     static_cast<unsigned long long>(count), what, cursor.remaining());
}

Result<OffCounts> read_header(TextCursor& cursor) {
  const std::string_view keyword = cursor.next();
  if (!is_keyword(keyword))
    return input_error("Line %zu begins with \"%s\", not with OFF, COFF, NOFF or STOFF.", cursor.line(),
                       quoted(keyword).c_str());
  const std::string_view word = cursor.next();
  if (word == "BINARY") return input_error("The file is OFF BINARY, of which only the text form is read.");
  OffCounts counts;
  WEFT_TRY(vertices, read_count(cursor, word, "vertices"));
  WEFT_TRY(faces, read_count(cursor, cursor.next_in_line(), "faces"));
  WEFT_CHECK(check_count(cursor, vertices, 6, "vertices"));
  WEFT_CHECK(check_count(cursor, faces, 8, "faces"));
  counts.vertices = vertices;
  counts.faces = faces;
  return counts;
}

// Takes its own copy of the cursor: only the corner numbers are looked at, so that the triangles fit exactly.
Result<std::uint64_t> count_triangles(TextCursor cursor, std::uint64_t face_count) {
  const std::uint64_t most_corners = (cursor.remaining() + 1) / 2;  // each takes two bytes
  std::uint64_t triangles = 0;
  for (std::uint64_t face = 0; face < face_count; ++face) {
    if (!cursor.next_filled_line())
      return input_error("The file ends after %llu of %llu faces.", static_cast<unsigned long long>(face),
                         static_cast<unsigned long long>(face_count));
    WEFT_TRY(corners, read_count(cursor, cursor.next_in_line(), "corners"));
    triangles += fan_size(std::min(corners, most_corners));
    if (corners > most_corners || triangles > most_corners)
      return input_error(
          "Line %zu announces a face of %llu corners, but all faces together have at most %llu.",
          cursor.line(), static_cast<unsigned long long>(corners),
          static_cast<unsigned long long>(most_corners));
  }
  return triangles;
}

Result<void> read_face(TextCursor& cursor, TriangleMesh& mesh) {
  cursor.next_filled_line();
  const auto corners = static_cast<std::uint64_t>(parse_integer(cursor.next_in_line()).value_or(0));
  if (corners < 3)
    return input_error("Line %zu has a face of %d corners, fewer than 3.", cursor.line(),
                       static_cast<int>(corners));
  PolygonFan fan(mesh.triangles);
  while (fan.corner_count() < corners) {
    const std::string_view word = cursor.next_in_line();
    if (word.empty())
      return input_error("Line %zu has %llu corners instead of %llu.", cursor.line(),
                         static_cast<unsigned long long>(fan.corner_count()),
                         static_cast<unsigned long long>(corners));
    const auto vertex = parse_integer(word);
    if (!vertex || *vertex < 0 || *vertex >= static_cast<std::int64_t>(mesh.positions.size()))
      return input_error("Line %zu names vertex \"%s\", but the mesh has %zu vertices, from 0.",
                         cursor.line(), quoted(word).c_str(), mesh.positions.size());
    fan.add(static_cast<std::uint32_t>(*vertex));
  }
  return {};
}

}  // namespace

Result<TriangleMesh> read_off(std::span<const std::byte> bytes) {
  TextCursor cursor(bytes, kOffRules);
  WEFT_TRY(counts, read_header(cursor));
  TriangleMesh mesh;
  mesh.positions.reserve(static_cast<std::size_t>(counts.vertices));
  for (std::uint64_t i = 0; i < counts.vertices; ++i) {
    if (!cursor.next_filled_line())
      return input_error("The file ends after %llu of %llu vertices.", static_cast<unsigned long long>(i),
                         static_cast<unsigned long long>(counts.vertices));
    WEFT_TRY(point, read_point(cursor));
    mesh.positions.push_back(point);
  }
  WEFT_TRY(triangle_count, count_triangles(cursor, counts.faces));
  mesh.triangles.reserve(static_cast<std::size_t>(triangle_count));
  for (std::uint64_t i = 0; i < counts.faces; ++i) WEFT_CHECK(read_face(cursor, mesh));
  WEFT_CHECK(check_mesh(mesh));
  return mesh;
}

}  // namespace weft::mesh
