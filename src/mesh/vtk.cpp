#include "mesh/vtk.hpp"

#include <optional>
#include <utility>

#include "mesh/check_tets.hpp"
#include "mesh/mixed_reader.hpp"
#include "mesh/number.hpp"

namespace weft::mesh {
namespace {

constexpr std::int64_t kVtkTet = 10;
constexpr std::size_t kVtkInt = 4;  // bytes

/// Bytes of a type in a binary file; 0 for a name that is none. A long is that of 64-bit Unix.
std::size_t vtk_size(std::string_view name) {
  static constexpr struct {
    std::string_view name;
    std::size_t size;
  } kTypes[] = {{"char", 1},           {"signed_char", 1},  {"unsigned_char", 1}, {"short", 2},
                {"unsigned_short", 2}, {"int", 4},          {"unsigned_int", 4},  {"float", 4},
                {"vtkidtype", 4},      {"vtktypeint32", 4}, {"vtktypeuint32", 4}, {"long", 8},
                {"unsigned_long", 8},  {"double", 8},       {"vtktypeint64", 8},  {"vtktypeuint64", 8},
                {"vtktypeint8", 1},    {"vtktypeuint8", 1}, {"vtktypeint16", 2},  {"vtktypeuint16", 2}};
  for (const auto& type : kTypes)
    if (same_word(type.name, name)) return type.size;
  return 0;
}

class VtkFile {
 public:
  explicit VtkFile(std::span<const std::byte> bytes) : reader_(bytes) {}
  Result<TetMesh> read();

 private:
  /// Numbers that are read later, side by side with others.
  struct Later {
    MixedReader reader;
    std::uint64_t count = 0;
    std::size_t size = 0;  // bytes of each
    Result<std::int64_t> next() { return reader.integer(size); }
  };

  Result<void> read_head();
  Result<void> read_section(std::string_view name);
  Result<void> read_points();
  Result<void> read_cells();
  Result<void> pass_field();
  void pass_metadata();
  Result<Later> later(std::uint64_t count, std::size_t size, const char* what);
  Result<Later> named_later(const char* name, std::uint64_t count);
  Result<std::uint64_t> cell_size();
  Result<void> read_tets();

  MixedReader reader_;
  bool has_offsets_ = false;  // version 5
  bool has_points_ = false;
  std::optional<Later> types_, cells_, offsets_;
  std::uint64_t row_count_ = 0;  // of CELLS: cells, and one more in version 5
  std::int64_t offset_ = 0;      // of the next cell
  TetMesh mesh_;
};

Result<void> VtkFile::read_head() {
  for (const std::string_view due : {"#", "vtk", "DataFile", "Version"})
    if (const std::string_view word = reader_.word_in_line(); !same_word(word, due))
      return input_error("The first line has \"%s\" where \"%s\" of \"# vtk DataFile Version\" is due.",
                         quoted(word).c_str(), quoted(due).c_str());
  const std::string_view version = reader_.word_in_line();
  if (version.size() < 3 || version[0] < '2' || version[0] > '5' || version[1] != '.')
    return input_error("The file is of version \"%s\" of VTK, not from 2.0 to 5.x.", quoted(version).c_str());
  has_offsets_ = version[0] == '5';
  reader_.end_line();
  reader_.end_line();  // the title
  const std::string_view form = reader_.word();
  if (!same_word(form, "ASCII") && !same_word(form, "BINARY"))
    return input_error("The third line has \"%s\", not ASCII or BINARY.", quoted(form).c_str());
  if (same_word(form, "BINARY")) reader_.set_form(NumberForm::BigEndian);
  const std::string_view set = reader_.word(), kind = reader_.word();
  if (same_word(set, "DATASET") && same_word(kind, "UNSTRUCTURED_GRID")) return {};
  return input_error("The file has \"%s %s\" where DATASET UNSTRUCTURED_GRID is due.", quoted(set).c_str(),
                     quoted(kind).c_str());
}

Result<void> VtkFile::read_points() {
  if (std::exchange(has_points_, true)) return input_error("The file has POINTS twice.");
  WEFT_TRY(count, reader_.count_in_line("points"));
  const std::string_view type = reader_.word_in_line();
  const bool is_float = same_word(type, "float");
  if (!is_float && !same_word(type, "double"))
    return input_error("The points are of type \"%s\", not float or double.", quoted(type).c_str());
  reader_.end_line();
  const std::size_t size = is_float ? 4 : 8;
  WEFT_CHECK(reader_.check_count(static_cast<std::int64_t>(count), 3, 3 * size, "points"));
  mesh_.positions.reserve(static_cast<std::size_t>(count));
  for (std::uint64_t i = 0; i < count; ++i) {
    WEFT_TRY(point, reader_.point(size));
    mesh_.positions.push_back(point);
  }
  return {};
}

Result<VtkFile::Later> VtkFile::later(std::uint64_t count, std::size_t size, const char* what) {
  reader_.end_line();
  WEFT_CHECK(reader_.check_count(static_cast<std::int64_t>(count), 1, size, what));
  Later numbers{reader_, count, size};
  WEFT_CHECK(reader_.skip(count, size));
  return numbers;
}

// OFFSETS or CONNECTIVITY, with its type.
Result<VtkFile::Later> VtkFile::named_later(const char* name, std::uint64_t count) {
  const std::string_view word = reader_.word(), type = reader_.word_in_line();
  const std::size_t size = vtk_size(type);
  if (!same_word(word, name) || (size != 4 && size != 8) || same_word(type, "float") ||
      same_word(type, "double"))
    return input_error("The file has \"%s %s\" where %s and a type such as vtktypeint64 are due.",
                       quoted(word).c_str(), quoted(type).c_str(), name);
  return later(count, size, "numbers");
}

Result<void> VtkFile::read_cells() {
  if (cells_) return input_error("The file has CELLS twice.");
  WEFT_TRY(count, reader_.count_in_line("cells"));
  WEFT_TRY(numbers, reader_.count_in_line("numbers"));
  row_count_ = count;
  if (!has_offsets_) {
    WEFT_SET(cells_, later(numbers, kVtkInt, "numbers"));
    return {};
  }
  WEFT_SET(offsets_, named_later("OFFSETS", count));
  WEFT_SET(cells_, named_later("CONNECTIVITY", numbers));
  return {};
}

// Arrays, each a line "name components rows type" and its numbers.
Result<void> VtkFile::pass_field() {
  reader_.word_in_line();  // its name
  WEFT_TRY(arrays, reader_.count_in_line("arrays"));
  for (std::uint64_t i = 0; i < arrays; ++i) {
    std::string_view name = reader_.word();
    if (same_word(name, "METADATA")) {
      pass_metadata();
      name = reader_.word();
    }
    if (name.empty()) return input_error("The file ends in a field, before its arrays are complete.");
    WEFT_TRY(components, reader_.count_in_line("components"));
    WEFT_TRY(rows, reader_.count_in_line("rows"));
    const std::string_view type = reader_.word_in_line();
    const std::size_t size = vtk_size(type);
    if (size == 0)
      return input_error("A field has type \"%s\", whose size is not known.", quoted(type).c_str());
    reader_.end_line();
    if (components == 0) continue;
    WEFT_CHECK(reader_.check_count(static_cast<std::int64_t>(components), 1, size, "components"));
    WEFT_CHECK(reader_.check_count(static_cast<std::int64_t>(rows), components, components * size, "rows"));
    WEFT_CHECK(reader_.skip(components * rows, size));
  }
  return {};
}

// Lines up to an empty one.
void VtkFile::pass_metadata() {
  while (reader_.end_line() && !reader_.word_in_line().empty()) {
  }
}

Result<void> VtkFile::read_section(std::string_view name) {
  if (same_word(name, "POINTS")) return read_points();
  if (same_word(name, "CELLS")) return read_cells();
  if (same_word(name, "FIELD")) return pass_field();
  if (same_word(name, "METADATA")) {
    pass_metadata();
    return {};
  }
  if (!same_word(name, "CELL_TYPES"))
    return input_error("The file has \"%s\" where POINTS, CELLS or CELL_TYPES is due.", quoted(name).c_str());
  if (types_) return input_error("The file has CELL_TYPES twice.");
  WEFT_TRY(count, reader_.count_in_line("cells"));
  WEFT_SET(types_, later(count, kVtkInt, "cell types"));
  return {};
}

// How many of cells_'s numbers the next cell has.
Result<std::uint64_t> VtkFile::cell_size() {
  std::int64_t size = 0;
  if (has_offsets_) {
    WEFT_TRY(end, offsets_->next());
    size = end - offset_;
    if (end < offset_) size = -1;
    offset_ = end;
  } else {
    WEFT_SET(size, cells_->next());
    if (cells_->count > 0) --cells_->count;
  }
  if (size < 0 || static_cast<std::uint64_t>(size) > cells_->count)
    return input_error("The cell at %s has %lld points, but the list of cells has %llu numbers left.",
                       (has_offsets_ ? *offsets_ : *cells_).reader.place().c_str(),
                       static_cast<long long>(size), static_cast<unsigned long long>(cells_->count));
  cells_->count -= static_cast<std::uint64_t>(size);
  return static_cast<std::uint64_t>(size);
}

// Types, sizes and points of the cells are read side by side, so that only tetrahedra take memory.
Result<void> VtkFile::read_tets() {
  const std::uint64_t rows = types_->count + (has_offsets_ ? 1 : 0);
  if (types_->count > 0 && row_count_ != rows)
    return input_error("CELLS has %llu rows for the %llu of CELL_TYPES, not %llu.",
                       static_cast<unsigned long long>(row_count_),
                       static_cast<unsigned long long>(types_->count), static_cast<unsigned long long>(rows));
  if (has_offsets_ && types_->count > 0) {
    WEFT_SET(offset_, offsets_->next());
    if (offset_ != 0)
      return input_error("The first offset of a cell is %lld, not 0.", static_cast<long long>(offset_));
  }
  for (std::uint64_t i = 0; i < types_->count; ++i) {
    WEFT_TRY(type, types_->next());
    WEFT_TRY(size, cell_size());
    if (type != kVtkTet) {
      WEFT_CHECK(cells_->reader.skip(size, cells_->size));
      continue;
    }
    if (size != 4)
      return input_error("The tetrahedron at %s has %llu points, not 4.", cells_->reader.place().c_str(),
                         static_cast<unsigned long long>(size));
    Tet tet{};
    for (std::uint32_t& corner : tet) {
      WEFT_TRY(vertex, cells_->next());
      if (vertex < 0 || vertex >= static_cast<std::int64_t>(mesh_.positions.size()))
        return input_error("The tetrahedron at %s names point %lld, but the file has %zu points, from 0.",
                           cells_->reader.place().c_str(), static_cast<long long>(vertex),
                           mesh_.positions.size());
      corner = static_cast<std::uint32_t>(vertex);
    }
    mesh_.tets.push_back(tet);
  }
  return {};
}

Result<TetMesh> VtkFile::read() {
  WEFT_CHECK(read_head());
  while (!(has_points_ && cells_ && types_)) {  // what comes after them is of no use
    const std::string_view name = reader_.word();
    if (name.empty())
      return input_error("The file ends before %s.", !has_points_ ? "POINTS"
                                                     : !cells_    ? "CELLS"
                                                                  : "CELL_TYPES");
    WEFT_CHECK(read_section(name));
  }
  WEFT_CHECK(read_tets());
  if (mesh_.tets.empty())
    return input_error("The file has %llu cells and no tetrahedra, cells of type %d.",
                       static_cast<unsigned long long>(types_->count), static_cast<int>(kVtkTet));
  WEFT_CHECK(check_tets(mesh_));
  return std::move(mesh_);
}

}  // namespace

Result<TetMesh> read_vtk(std::span<const std::byte> bytes) { return VtkFile(bytes).read(); }

}  // namespace weft::mesh
