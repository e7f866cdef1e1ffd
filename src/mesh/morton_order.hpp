// Points along a space-filling curve, so that those that follow each other lie near each other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.hpp"

namespace weft::mesh {

/// The points' indices along the Morton curve of 1024 cells a side; of points in one cell the lower first.
std::vector<std::uint32_t> morton_order(std::span<const Vec3d> points);

}  // namespace weft::mesh
