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

/// "7", "7/7", "7//7" or "7/7/7": a vertex has the same number in all lists.
void append_corner(std::string& text, std::uint64_t number, const VertexAttributes& attributes) {
  append_integer(text, number);
  if (!attributes.texture.empty() || !attributes.normals.empty()) text += '/';
  if (!attributes.texture.empty()) append_integer(text, number);
  if (attributes.normals.empty()) return;
  text += '/';
  append_integer(text, number);
}

/// The bytes of a file, seldom exceeded, so that it is seldom moved while it grows.
std::size_t usual_size(const TriangleMesh& mesh, const VertexAttributes& attributes) {
  constexpr std::size_t kNumber = 13;  // with the space before it
  const std::size_t vertices = mesh.positions.size(), digits = std::to_string(vertices).size();
  const bool texture = !attributes.texture.empty(), normals = !attributes.normals.empty();
  const std::size_t lists = 1U + (texture ? 1U : 0U) + (normals ? 1U : 0U);
  const std::size_t numbers = 3U + (texture ? 2U : 0U) + (normals ? 3U : 0U);
  return vertices * (kNumber * numbers + 3 * lists) +
         mesh.triangles.size() * (2 + 3 * (1 + (digits + 1) * lists));
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

std::vector<std::byte> write_obj(const TriangleMesh& mesh, const VertexAttributes& attributes) {
  assert(check_mesh(mesh));
  std::vector<std::byte> bytes;
  bytes.reserve(usual_size(mesh, attributes));
  std::string line;
  const auto add_line = [&] {
    line += '\n';
    const auto* begin = reinterpret_cast<const std::byte*>(line.data());
    bytes.insert(bytes.end(), begin, begin + line.size());
    line.clear();
  };
  const auto add = [&](const char* keyword, std::initializer_list<float> values) {
    line += keyword;
    for (const float value : values) {
      line += ' ';
      append_float(line, value);
    }
    add_line();
  };
  for (const Vec3f& p : mesh.positions) add("v", {p.x, p.y, p.z});
  for (const auto& [u, v] : attributes.texture) add("vt", {u, v});
  for (const Vec3f& n : attributes.normals) add("vn", {n.x, n.y, n.z});
  for (const Triangle& triangle : mesh.triangles) {
    line += 'f';
    for (const std::uint32_t vertex : triangle) {
      line += ' ';
      append_corner(line, std::uint64_t{vertex} + 1, attributes);
    }
    add_line();
  }
  return bytes;
}

}  // namespace weft::mesh
