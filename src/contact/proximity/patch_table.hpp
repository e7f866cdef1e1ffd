// The patches of cloths that are grids, on the host: docs/contact.md, Patches.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/proximity/implicit_tree.hpp"
#include "model/model.hpp"

namespace weft::contact {

/// Mirror of src/contact/proximity/patches.wgsl.
struct PatchPlace {
  std::uint32_t cell_vertex = 0, patch_vertex = 0, stride = 0;
  std::uint32_t cell_size = 0, patch_size = 0;  // quads: columns, and in the upper half rows
  float per_width = 0, per_height = 0;          // [1/m]
  std::uint32_t columns = 0;
};
static_assert(sizeof(PatchPlace) == 32);

/// The most of a cell: 8 by 8.
inline constexpr std::uint32_t kCellQuads = 64;

inline constexpr std::uint32_t kNoCell = 0xffffffff;

/// The table of cells and patches of all cloths, one below the other; without places where no cloth is a grid, or where
/// the table would have more rows or columns than the cells of a box can say.
struct PatchTable {
  std::vector<PatchPlace> places;
  std::uint32_t columns = 0;
  /// Of each triangle of the model: the column of its cell, and in the upper half its row; or kNoCell.
  std::vector<std::uint32_t> cells;

  PatchTable() = default;
  explicit PatchTable(const Model& model);
  std::uint32_t cell_of(std::uint32_t triangle) const {
    return triangle < cells.size() ? cells[triangle] : kNoCell;
  }
  /// Writes the cells of each box into the words of the cloths' tree, whose triangles are in this order.
  void write_cells(const ImplicitTree& tree, std::span<const std::uint32_t> order,
                   std::span<TreeWord> words) const;

 private:
  void add(const Body& body);
};

}  // namespace weft::contact
