#pragma once

#include "bench/detail.hpp"
#include "sim/world.hpp"

namespace weft::bench {

/// A sheet at a time.
struct SheetShape {
  double time = 0;  // [s]
  std::vector<Vec3d> position;
  double kinetic_energy = 0;  // of the nodes that were simulated [J]
};

/// A sheet beside its reference at the same time.
struct SheetError {
  double time = 0;                                          // [s]
  double position = 0;                                      // position_error
  double normal_degrees = 0;                                // mean_normal_angle
  double edge_stretch = 0, edge_stretch_reference = 0;      // of free_sides
  double kinetic_energy = 0, kinetic_energy_reference = 0;  // [J]
};

SheetShape shape_of(const Model& model, const sim::Snapshot& state, double time);

/// The sheet of a coarse model's first cloth as a finer model's nodes draw it (upsample).
SheetShape upsampled(const Model& coarse, const SheetShape& shape, const Model& fine);

/// Of shapes of a model's first cloth, at the reference's times.
std::vector<SheetError> sheet_errors(const Model& model, std::span<const SheetShape> shapes,
                                     std::span<const SheetShape> reference);

}  // namespace weft::bench
