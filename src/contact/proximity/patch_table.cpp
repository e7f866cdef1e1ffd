#include "contact/proximity/patch_table.hpp"

#include <algorithm>

namespace weft::contact {
namespace {

constexpr std::uint32_t kMostCells = 0xffff, kLeastQuads = 4, kMostQuads = 8;
static_assert(kMostQuads * kMostQuads == kCellQuads);
/// A cell is at least so long, if it has fewer than kMostQuads, that cloth at 5 m/s does not go farther until the next
/// search of a solver with steps of 1/480 s [m]: pairs so near lie in one patch.
constexpr double kLeastLength = 0.013;

double width_of(const mesh::Grid& grid) { return grid.width / (grid.nx - 1); }
double height_of(const mesh::Grid& grid) { return grid.height / (grid.ny - 1); }

std::uint32_t cell_quads(const mesh::Grid& grid) {
  std::uint32_t quads = kLeastQuads;
  while (quads < kMostQuads && quads * std::min(width_of(grid), height_of(grid)) < kLeastLength) quads *= 2;
  return quads;
}
std::uint32_t cell_count(std::uint32_t nodes, std::uint32_t quads) { return (nodes - 1 + quads - 1) / quads; }

/// What a cell or a patch has of a row or a column of the grid.
struct Span {
  std::uint32_t first = 0, count = 0;  // quads
};
Span span_of(std::uint32_t first_cell, std::uint32_t end_cell, std::uint32_t quads, std::uint32_t nodes) {
  const std::uint32_t first = std::min(first_cell * quads, nodes - 1),
                      end = std::min(end_cell * quads, nodes - 1);
  return {first, end - first};
}
Span cell_span(std::uint32_t cell, std::uint32_t quads, std::uint32_t nodes) {
  return span_of(cell, cell + 1, quads, nodes);
}
/// The cell before, if there is one, and this one.
Span patch_span(std::uint32_t cell, std::uint32_t quads, std::uint32_t nodes) {
  return span_of(cell - std::min(cell, 1U), cell + 1, quads, nodes);
}
std::uint32_t size_of(Span row, Span column) {
  return row.count > 0 && column.count > 0 ? row.count | column.count << 16U : 0;
}

/// Columns and rows of the table: the first ones, and the last ones. All of it: in no patch.
struct Cells {
  std::uint32_t column = 0, row = 0, last_column = kMostCells, last_row = kMostCells;
  explicit Cells(std::uint32_t cell) {
    if (cell == kNoCell) return;
    column = last_column = cell & kMostCells;
    row = last_row = cell >> 16U;
  }
  void add(const Cells& other) {
    column = std::min(column, other.column);
    row = std::min(row, other.row);
    last_column = std::max(last_column, other.last_column);
    last_row = std::max(last_row, other.last_row);
  }
};

}  // namespace

PatchTable::PatchTable(const Model& model) {
  std::uint64_t rows = 0;
  std::uint64_t most = 0;
  for (const Body& body : model.bodies) {
    if (!body.grid) continue;
    const std::uint32_t quads = cell_quads(*body.grid);
    most = std::max<std::uint64_t>(most, cell_count(body.grid->nx, quads) + 1);
    rows += cell_count(body.grid->ny, quads) + 1;
  }
  if (rows > kMostCells || most > kMostCells) return;
  columns = static_cast<std::uint32_t>(most);
  cells.assign(model.triangles.size(), kNoCell);
  for (const Body& body : model.bodies)
    if (body.grid) add(body);
}

/// The last row and column of a cloth have patches, and no cells.
void PatchTable::add(const Body& body) {
  const mesh::Grid& grid = *body.grid;
  const std::uint32_t quads = cell_quads(grid), row_quads = grid.nx - 1;
  const auto first_row = static_cast<std::uint32_t>(places.size() / columns);
  for (std::uint32_t t = 0; t < body.triangle_count; ++t) {
    const std::uint32_t quad = t / 2;  // mesh::grid_triangles
    cells[body.first_triangle + t] = quad % row_quads / quads | (first_row + quad / row_quads / quads) << 16U;
  }
  for (std::uint32_t row = 0; row <= cell_count(grid.ny, quads); ++row)
    for (std::uint32_t column = 0; column < columns; ++column) {
      PatchPlace place;
      place.columns = columns;
      place.stride = grid.nx;
      place.per_width = static_cast<float>(1 / width_of(grid));
      place.per_height = static_cast<float>(1 / height_of(grid));
      const Span along = cell_span(column, quads, grid.nx), down = cell_span(row, quads, grid.ny);
      place.cell_vertex = body.first_vertex + down.first * grid.nx + along.first;
      place.cell_size = size_of(along, down);
      const Span patch_along = patch_span(column, quads, grid.nx),
                 patch_down = patch_span(row, quads, grid.ny);
      place.patch_vertex = body.first_vertex + patch_down.first * grid.nx + patch_along.first;
      place.patch_size = size_of(patch_along, patch_down);
      places.push_back(place);
    }
}

void PatchTable::write_cells(const ImplicitTree& tree, std::span<const std::uint32_t> order,
                             std::span<TreeWord> words) const {
  std::vector<Cells> below;
  for (const std::uint32_t triangle : order) below.emplace_back(cell_of(triangle));
  std::uint32_t arity = kTreeLeafTriangles;
  std::size_t word = tree.first + 1 + tree.counts.size();
  for (std::size_t level = 0; level < tree.counts.size(); ++level) {
    std::vector<Cells> boxes;
    for (std::size_t first = 0; first < below.size(); first += arity) {
      Cells box = below[first];
      for (std::size_t k = first + 1; k < std::min(below.size(), first + arity); ++k) box.add(below[k]);
      boxes.push_back(box);
      words[word].w = box.column | box.last_column << 16U;
      words[word + 1].w = box.row | box.last_row << 16U;
      word += 2;
    }
    below = std::move(boxes);
    arity = kTreeArity;
  }
}

}  // namespace weft::contact
