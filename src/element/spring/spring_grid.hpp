#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/vec.hpp"
#include "element/spring/build.hpp"

namespace weft {

/// The springs of a grid cloth, which follow from where a node is. Mirror: src/element/spring/spring_grid.wgsl.
struct SpringGrid {
  std::uint32_t first_vertex = 0, nx = 0, ny = 0;
  std::uint32_t uniform_weights = 0;  // 1: springs along the boundary count in full
  Vec4f stiffness;                    // structural, shear, bend [N/m]
  Vec4f damping;                      // the same; 0 where the stiffness is 0 [N·s/m]
  Vec4f rest_length;                  // structural along i, along j, shear [m]
  std::array<float, 2> bending = {};  // of second differences along i, along j [N/m]
  std::array<float, 2> longest =
      {};  // beyond which structural ones are stiffer, along i, along j; 0: none [m]

  bool operator==(const SpringGrid&) const = default;
};
static_assert(sizeof(SpringGrid) == 80 && offsetof(SpringGrid, bending) == 64);

SpringGrid spring_grid(const mesh::Grid& grid, const SpringMaterial& material, std::uint32_t first_vertex);

}  // namespace weft
