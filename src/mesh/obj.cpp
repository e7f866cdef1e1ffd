#include "mesh/obj.hpp"

#include <cassert>
#include <initializer_list>

#include "mesh/number.hpp"
#include "mesh/polygon.hpp"
#include "mesh/text_cursor.hpp"

namespace weft::mesh {
namespace {

constexpr TextCursor::Rules kObjRules{.comments = true, .continuations = true};

struct ObjCounts {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
};

// A pass of its own, so that each array is allocated once, in the size that the text really fills.
ObjCounts count(std::span<const std::byte> bytes) {
  ObjCounts counts;
  TextCursor cursor(bytes, kObjRules);
  do {
    const std::string_view keyword = cursor.next_in_line();
    if (keyword == "v") ++counts.vertices;
    if (keyword != "f") continue;
    std::uint64_t corners = 0;
    while (!cursor.next_in_line().empty()) ++corners;
    counts.triangles += fan_size(corners);
  } while (cursor.next_line());
  return counts;
}

// "7", "7/2", "7/2/5" or "7//5": only the first number matters here, the others must be numbers all the same.
std::optional<std::int64_t> vertex_number(std::string_view corner) {
  const std::size_t slash = corner.find('/');
  const auto number = parse_integer(corner.substr(0, slash));
  if (!number || slash == std::string_view::npos) return number;
  const std::string_view rest = corner.substr(slash + 1);
  const std::size_t second = rest.find('/');
  const std::string_view texture = rest.substr(0, second);
  if (!texture.empty() && !parse_integer(texture)) return std::nullopt;
  if (second == std::string_view::npos) return texture.empty() ? std::nullopt : number;
  return parse_integer(rest.substr(second + 1)) ? number : std::nullopt;
}

Result<void> read_face(TextCursor& cursor, std::size_t vertex_count, TriangleMesh& mesh) {
  const auto total = static_cast<std::int64_t>(vertex_count);
  const auto so_far = static_cast<std::int64_t>(mesh.positions.size());
  PolygonFan fan(mesh.triangles);
  for (std::string_view corner = cursor.next_in_line(); !corner.empty(); corner = cursor.next_in_line()) {
    const auto number = vertex_number(corner);
    if (!number)
      return input_error(
          "Line %zu has the corner \"%s\", which is not of the form v, v/vt, v/vt/vn or v//vn.",
          cursor.line(), quoted(corner).c_str());
    if (*number == 0 || *number > total)
      return input_error("Line %zu names vertex %lld, which is not in 1 to %lld.", cursor.line(),
                         static_cast<long long>(*number), static_cast<long long>(total));
    if (*number < -so_far)
      return input_error("Line %zu names vertex %lld, but only %lld vertices come before it.", cursor.line(),
                         static_cast<long long>(*number), static_cast<long long>(so_far));
    fan.add(static_cast<std::uint32_t>(*number > 0 ? *number - 1 : so_far + *number));
  }
  if (fan.corner_count() < 3)
    return input_error("Line %zu has a face of %d corners, fewer than 3.", cursor.line(),
                       static_cast<int>(fan.corner_count()));
  return {};
}

void append_line(std::string& text, const char* keyword, std::initializer_list<float> values) {
  text += keyword;
  for (const float value : values) {
    text += ' ';
    append_float(text, value);
  }
  text += '\n';
}

/// "7", "7/7", "7//7" or "7/7/7": a vertex has the same number in all lists.
void append_corner(std::string& text, std::uint64_t number, const VertexAttributes& attributes) {
  append_integer(text, number);
  if (!attributes.texture.empty() || !attributes.normals.empty()) text += '/';
  if (!attributes.texture.empty()) append_integer(text, number);
  if (attributes.normals.empty()) return;
  text += '/';
  append_integer(text, number);
}

}  // namespace

Result<TriangleMesh> read_obj(std::span<const std::byte> bytes) {
  const ObjCounts counts = count(bytes);
  TriangleMesh mesh;
  mesh.positions.reserve(counts.vertices);
  mesh.triangles.reserve(counts.triangles);
  TextCursor cursor(bytes, kObjRules);
  do {
    const std::string_view keyword = cursor.next_in_line();
    if (keyword == "v") {
      WEFT_TRY(point, read_point(cursor));
      mesh.positions.push_back(point);
    } else if (keyword == "f") {
      WEFT_CHECK(read_face(cursor, counts.vertices, mesh));
    }
  } while (cursor.next_line());
  WEFT_CHECK(check_mesh(mesh));
  return mesh;
}

std::string write_obj(const TriangleMesh& mesh, const VertexAttributes& attributes) {
  assert(check_mesh(mesh));
  std::string text;
  text.reserve((attributes.normals.empty() ? 32 : 96) * (mesh.positions.size() + mesh.triangles.size()));
  for (const Vec3f& p : mesh.positions) append_line(text, "v", {p.x, p.y, p.z});
  for (const auto& [u, v] : attributes.texture) append_line(text, "vt", {u, v});
  for (const Vec3f& n : attributes.normals) append_line(text, "vn", {n.x, n.y, n.z});
  for (const Triangle& triangle : mesh.triangles) {
    text += 'f';
    for (const std::uint32_t vertex : triangle) {
      text += ' ';
      append_corner(text, std::uint64_t{vertex} + 1, attributes);
    }
    text += '\n';
  }
  return text;
}

}  // namespace weft::mesh
