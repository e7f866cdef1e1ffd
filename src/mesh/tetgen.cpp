#include "mesh/tetgen.hpp"

#include "mesh/check_tets.hpp"
#include "mesh/number.hpp"
#include "mesh/text_cursor.hpp"

namespace weft::mesh {
namespace {

constexpr TextCursor::Rules kTetgenRules{.comments = true, .continuations = false};

Result<std::uint64_t> tetgen_number(TextCursor& cursor, std::string_view word, const char* what) {
  const auto number = parse_integer(word);
  if (!number || *number < 0)
    return input_error("Line %zu has \"%s\" where the %s is due, a number from 0.", cursor.line(),
                       quoted(word).c_str(), what);
  return static_cast<std::uint64_t>(*number);
}

// The first word of the text, of a line that may have others before it without words.
Result<std::uint64_t> tetgen_count(TextCursor& cursor, std::uint64_t least_size, const char* what) {
  WEFT_TRY(count, tetgen_number(cursor, cursor.next(), what));
  const std::uint64_t most = (cursor.remaining() + 1) / least_size;
  if (count <= most) return count;
  return input_error("Line %zu has %llu as the %s, but the %zu bytes after it hold at most %llu.",
                     cursor.line(), static_cast<unsigned long long>(count), what, cursor.remaining(),
                     static_cast<unsigned long long>(most));
}

struct TetgenNodes {
  std::uint64_t first = 0;  // number of the first
  std::vector<Vec3f> positions;
};

Result<TetgenNodes> read_nodes(std::span<const std::byte> bytes) {
  TextCursor cursor(bytes, kTetgenRules);
  WEFT_TRY(count, tetgen_count(cursor, 8, "number of nodes"));
  if (const std::string_view dimension = cursor.next_in_line(); dimension != "3")
    return input_error("Line %zu gives the nodes \"%s\" dimensions, not 3.", cursor.line(),
                       quoted(dimension).c_str());
  TetgenNodes nodes;
  nodes.positions.reserve(static_cast<std::size_t>(count));
  for (std::uint64_t row = 0; row < count; ++row) {
    if (!cursor.next_filled_line())
      return input_error("The file ends after %llu of %llu nodes.", static_cast<unsigned long long>(row),
                         static_cast<unsigned long long>(count));
    WEFT_TRY(number, tetgen_number(cursor, cursor.next_in_line(), "number of a node"));
    if (row == 0) nodes.first = number;
    if (nodes.first > 1 || number != nodes.first + row)
      return input_error(
          "Line %zu has node %llu, but nodes are numbered one by one from 0 or 1, and %llu came before.",
          cursor.line(), static_cast<unsigned long long>(number), static_cast<unsigned long long>(row));
    WEFT_TRY(point, read_point(cursor));
    nodes.positions.push_back(point);
  }
  return nodes;
}

Result<std::vector<Tet>> read_ele(std::span<const std::byte> bytes, const TetgenNodes& nodes) {
  TextCursor cursor(bytes, kTetgenRules);
  WEFT_TRY(count, tetgen_count(cursor, 10, "number of tetrahedra"));
  if (const std::string_view corners = cursor.next_in_line(); corners != "4" && corners != "10")
    return input_error("Line %zu gives the tetrahedra \"%s\" nodes, not 4 or 10.", cursor.line(),
                       quoted(corners).c_str());
  std::vector<Tet> tets;
  tets.reserve(static_cast<std::size_t>(count));
  const std::uint64_t end = nodes.first + nodes.positions.size();
  for (std::uint64_t row = 0; row < count; ++row) {
    if (!cursor.next_filled_line())
      return input_error("The file ends after %llu of %llu tetrahedra.", static_cast<unsigned long long>(row),
                         static_cast<unsigned long long>(count));
    WEFT_CHECK(tetgen_number(cursor, cursor.next_in_line(), "number of a tetrahedron"));
    Tet tet{};
    for (std::uint32_t& corner : tet) {
      WEFT_TRY(number, tetgen_number(cursor, cursor.next_in_line(), "number of a node"));
      if (number < nodes.first || number >= end)
        return input_error("Line %zu names node %llu, which is not among the %zu from %llu.", cursor.line(),
                           static_cast<unsigned long long>(number), nodes.positions.size(),
                           static_cast<unsigned long long>(nodes.first));
      corner = static_cast<std::uint32_t>(number - nodes.first);
    }
    tets.push_back(tet);
  }
  return tets;
}

}  // namespace

Result<TetMesh> read_tetgen(std::span<const std::byte> ele, std::span<const std::byte> node) {
  auto nodes = read_nodes(node);
  if (!nodes) return nodes.error().while_doing("reading the nodes");
  WEFT_TRY(tets, read_ele(ele, *nodes));
  TetMesh mesh{std::move(nodes->positions), std::move(tets)};
  WEFT_CHECK(check_tets(mesh));
  return mesh;
}

}  // namespace weft::mesh
