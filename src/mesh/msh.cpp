#include "mesh/msh.hpp"

#include <utility>

#include "mesh/check_tets.hpp"
#include "mesh/mixed_reader.hpp"
#include "mesh/msh_nodes.hpp"

namespace weft::mesh {
namespace {

constexpr std::int64_t kMshTet = 4;
constexpr std::size_t kInt = 4, kLong = 8,
                      kDouble = 8;  // bytes, in a binary file; kLong is version 4's size_t

/// Nodes of an element by its type; 0 for a type that is not known, whose size nothing says.
std::uint64_t msh_node_count(std::int64_t type) {
  static constexpr std::uint8_t kCounts[] = {0, 2,  3,  4,  4, 8,  6,  5,  3,  6,  9, 10, 27, 18, 14, 1,
                                             8, 20, 15, 13, 9, 10, 12, 15, 15, 21, 4, 5,  6,  20, 35, 56};
  if (type == 92) return 64;
  if (type == 93) return 125;
  return type > 0 && type < std::int64_t{std::size(kCounts)} ? kCounts[type] : 0;
}

class MshFile {
 public:
  explicit MshFile(std::span<const std::byte> bytes) : reader_(bytes) {}
  Result<TetMesh> read();

 private:
  Result<void> read_format();
  Result<void> read_section(std::string_view name);
  Result<std::int64_t> size() { return reader_.integer(kLong); }
  Result<std::int64_t> number() { return reader_.integer(kInt); }
  Result<void> read_old_nodes();
  Result<void> read_new_nodes();
  Result<void> read_old_elements();
  Result<void> read_new_elements();
  Result<void> read_elements(std::int64_t count, std::int64_t type, std::uint64_t numbers_before,
                             std::size_t width);

  MixedReader reader_;
  bool old_ = false;  // version 2.2
  bool has_nodes_ = false, has_elements_ = false;
  MshNodes nodes_;
  TetMesh mesh_;
};

Result<void> MshFile::read_format() {
  if (const std::string_view word = reader_.word(); word != "$MeshFormat")
    return input_error("The file begins with \"%s\", not with $MeshFormat.", quoted(word).c_str());
  const std::string_view version = reader_.word();
  if (version != "2.2" && version != "4.1")
    return input_error("The file is of version \"%s\" of MSH, not 2.2 or 4.1.", quoted(version).c_str());
  old_ = version == "2.2";
  const std::string_view binary = reader_.word_in_line(), width = reader_.word_in_line();
  if ((binary != "0" && binary != "1") || width != "8")
    return input_error("The format is \"%s\" \"%s\", not 0 (text) or 1 (binary) with numbers of 8 bytes.",
                       quoted(binary).c_str(), quoted(width).c_str());
  if (binary == "1") {
    reader_.end_line();
    reader_.set_form(NumberForm::LittleEndian);
    WEFT_TRY(one, number());
    if (one != 1)
      return input_error("The file has %lld where a little-endian one is due: it has another order of bytes.",
                         static_cast<long long>(one));
  }
  if (const std::string_view word = reader_.word(); word != "$EndMeshFormat")
    return input_error("The file has \"%s\" where $EndMeshFormat is due.", quoted(word).c_str());
  return {};
}

// Number, x, y, z.
Result<void> MshFile::read_old_nodes() {
  WEFT_TRY(count, reader_.count_in_line("nodes"));
  reader_.end_line();
  const auto rows = static_cast<std::int64_t>(count);
  WEFT_CHECK(reader_.check_count(rows, 4, kInt + 3 * kDouble, "nodes"));
  nodes_.reserve(static_cast<std::size_t>(count));
  mesh_.positions.reserve(static_cast<std::size_t>(count));
  for (std::int64_t row = 0; row < rows; ++row) {
    WEFT_TRY(tag, number());
    WEFT_TRY(point, reader_.point(kDouble));
    nodes_.add(tag);
    mesh_.positions.push_back(point);
  }
  return {};
}

// Blocks, each of all its numbers, then all its points, which may have their parameters on a curve after them.
Result<void> MshFile::read_new_nodes() {
  WEFT_TRY(blocks, size());
  WEFT_TRY(total, size());
  WEFT_CHECK(reader_.skip(2, kLong));  // least and largest number
  WEFT_CHECK(reader_.check_count(total, 4, kLong + 3 * kDouble, "nodes"));
  nodes_.reserve(static_cast<std::size_t>(total));
  mesh_.positions.reserve(static_cast<std::size_t>(total));
  for (std::int64_t block = 0; block < blocks; ++block) {
    WEFT_TRY(dimension, number());
    WEFT_CHECK(reader_.skip(1, kInt));  // the curve, surface or volume
    WEFT_TRY(parametric, number());
    WEFT_TRY(count, size());
    if (dimension < 0 || dimension > 3)
      return input_error("The nodes at %s lie in %lld dimensions, which is not in 0 to 3.",
                         reader_.place().c_str(), static_cast<long long>(dimension));
    const auto left = total - static_cast<std::int64_t>(nodes_.size());
    if (count < 0 || count > left)
      return input_error("The block at %s has %lld nodes, but only %lld are left of the %lld announced.",
                         reader_.place().c_str(), static_cast<long long>(count), static_cast<long long>(left),
                         static_cast<long long>(total));
    for (std::int64_t row = 0; row < count; ++row) {
      WEFT_TRY(tag, size());
      nodes_.add(tag);
    }
    for (std::int64_t row = 0; row < count; ++row) {
      WEFT_TRY(point, reader_.point(kDouble));
      mesh_.positions.push_back(point);
      if (parametric != 0) WEFT_CHECK(reader_.skip(static_cast<std::uint64_t>(dimension), kDouble));
    }
  }
  return {};
}

// Elements of one type: `numbers_before` the nodes of each, its own number among them, are passed over.
Result<void> MshFile::read_elements(std::int64_t count, std::int64_t type, std::uint64_t numbers_before,
                                    std::size_t width) {
  const std::uint64_t corners = msh_node_count(type);
  if (corners == 0)
    return input_error("The element at %s is of type %lld, which is not known, nor how many nodes it has.",
                       reader_.place().c_str(), static_cast<long long>(type));
  WEFT_CHECK(
      reader_.check_count(count, numbers_before + corners, width * (numbers_before + corners), "elements"));
  if (type != kMshTet)
    return reader_.skip(static_cast<std::uint64_t>(count) * (numbers_before + corners), width);
  for (std::int64_t row = 0; row < count; ++row) {
    WEFT_CHECK(reader_.skip(numbers_before, width));
    Tet tet{};
    for (std::uint32_t& corner : tet) {
      WEFT_TRY(tag, reader_.integer(width));
      const auto vertex = nodes_.find(tag);
      if (!vertex)
        return input_error("The tetrahedron at %s names node %lld, which is none of the file's %zu.",
                           reader_.place().c_str(), static_cast<long long>(tag), nodes_.size());
      corner = *vertex;
    }
    mesh_.tets.push_back(tet);
  }
  return {};
}

// Text: number, type, number of tags, tags, nodes. Bytes: type, elements that follow, number of tags; then of each its
// number, tags and nodes.
Result<void> MshFile::read_old_elements() {
  WEFT_TRY(count, reader_.count_in_line("elements"));
  reader_.end_line();
  const bool is_text = reader_.form() == NumberForm::Text;
  const auto total = static_cast<std::int64_t>(count);
  WEFT_CHECK(reader_.check_count(total, 4, 2 * kInt, "elements"));
  for (std::int64_t left = total; left > 0;) {
    if (is_text) WEFT_CHECK(reader_.skip(1, kInt));
    WEFT_TRY(type, number());
    std::int64_t together = 1;
    if (!is_text) WEFT_SET(together, number());
    WEFT_TRY(tags, number());
    if (together < 1 || together > left)
      return input_error("The block at %s has %lld elements, but %lld are left of the %lld announced.",
                         reader_.place().c_str(), static_cast<long long>(together),
                         static_cast<long long>(left), static_cast<long long>(total));
    WEFT_CHECK(reader_.check_count(tags, 1, kInt, "tags"));
    WEFT_CHECK(read_elements(together, type, static_cast<std::uint64_t>(tags) + (is_text ? 0 : 1), kInt));
    left -= together;
  }
  return {};
}

// Blocks of one type each.
Result<void> MshFile::read_new_elements() {
  WEFT_TRY(blocks, size());
  WEFT_CHECK(reader_.skip(3, kLong));  // their elements, least and largest number
  for (std::int64_t block = 0; block < blocks; ++block) {
    WEFT_CHECK(reader_.skip(2, kInt));  // the dimension, and the volume in it
    WEFT_TRY(type, number());
    WEFT_TRY(count, size());
    WEFT_CHECK(read_elements(count, type, 1, kLong));
  }
  return {};
}

Result<void> MshFile::read_section(std::string_view name) {
  if (name == "$Nodes") {
    if (std::exchange(has_nodes_, true)) return input_error("The file has section $Nodes twice.");
    reader_.end_line();
    WEFT_CHECK(old_ ? read_old_nodes() : read_new_nodes());
    WEFT_CHECK(nodes_.finish());
  } else if (name == "$ParametricNodes") {  // of version 2.2, in place of $Nodes
    return input_error("The nodes have parametric coordinates, which are not read: save the file without.");
  } else if (name == "$Elements") {
    if (!has_nodes_) return input_error("Section $Elements comes before section $Nodes.");
    if (std::exchange(has_elements_, true)) return input_error("The file has section $Elements twice.");
    reader_.end_line();
    WEFT_CHECK(old_ ? read_old_elements() : read_new_elements());
  }
  const std::string end = "$End" + std::string(name.substr(1));
  if (reader_.pass(end)) return {};
  return input_error("Section \"%s\" has no end.", quoted(name).c_str());
}

Result<TetMesh> MshFile::read() {
  WEFT_CHECK(read_format());
  for (std::string_view name = reader_.word(); !name.empty(); name = reader_.word()) {
    if (name.size() < 2 || name.size() > 64 || name[0] != '$')
      return input_error("The file has \"%s\" where the name of a section, with $, is due.",
                         quoted(name).c_str());
    WEFT_CHECK(read_section(name));
  }
  if (mesh_.tets.empty())
    return input_error("The file has %zu nodes and no tetrahedra of four of them, elements of type %d.",
                       nodes_.size(), static_cast<int>(kMshTet));
  WEFT_CHECK(check_tets(mesh_));
  return std::move(mesh_);
}

}  // namespace

Result<TetMesh> read_msh(std::span<const std::byte> bytes) { return MshFile(bytes).read(); }

}  // namespace weft::mesh
