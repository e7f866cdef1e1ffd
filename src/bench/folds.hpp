// Sheets that lie in folds: start positions of which it is known by their making that nothing crosses.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.hpp"

namespace weft::bench {

/// A sheet in layers upon each other, which run to and fro along x, and which a wave bends all together.
///
///      ____________
///     (____________    layer 2, and so on
///      ____________)   layer 1
///     (____________    layer 0                y up, x to the right
///
struct Folds {
  double gap = 0;              // from layer to layer along y [m]; less than the nodes' spacing
  std::vector<double> layers;  // how long each is [m]; what is left of the sheet lies in the last
  double slope = 0;            // the wave's largest
  double wave_length = 1;      // [m]
  double phase = 0;            // [rad]
};

/// `layer_count` equal layers out of a part of the sheet, from 0 to 1; the rest of it lies flat.
Folds even_folds(double size, double gap, std::uint32_t layer_count, double part);
/// The same with layers of which the longest may be three times the shortest, bent by a wave.
Folds crumpled_folds(double size, double gap, std::uint32_t layer_count, double part, std::uint64_t seed);

/// Where the nodes of a row are across the folds (z is 0) [m]: each exactly `spacing` from the one before.
/// Layers are the same curve moved along y, a step from one to the next stays between the two, so no part
/// of the row meets another.
std::vector<Vec3d> fold_profile(std::uint32_t count, double spacing, const Folds& folds);

/// Where the nodes of a column are along the folds [m], likewise `spacing` apart: a line along z that sways
/// by `slope` at most. Every row is moved as a whole by its node of the column, so rows stay free of
/// crossings.
std::vector<Vec3d> fold_column(std::uint32_t count, double spacing, double slope, std::uint64_t seed);

}  // namespace weft::bench
