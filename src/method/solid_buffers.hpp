// A body with volume on the GPU: its tetrahedra, as every method's kernels read them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gpu/buffer.hpp"
#include "model/model.hpp"

namespace weft {

/// Mirror of SolidLaw in src/element/tet/law.wgsl.
struct SolidLawBlock {
  float mu = 0, lambda = 0;  // [Pa]
  float delay = 0;           // [s]
  std::uint32_t energy = 0;  // tet::Energy
};
static_assert(sizeof(SolidLawBlock) == 16);

/// Mirror of SolidParams in src/method/solid_params.wgsl.
struct SolidParams {
  std::uint32_t first = 0, count = 0;
  std::uint32_t tets = 0, first_tet = 0;  // the second: among those of all bodies that kernels have together
  SolidLawBlock law;
};
static_assert(sizeof(SolidParams) == 32 && offsetof(SolidParams, law) == 16);

/// Each node's places in a list of the corners of all tetrahedra: rows of nodes, then their entries. `bodies`:
/// neighbours in the model.
std::vector<std::uint32_t> tet_corners_of_nodes(const Model& model, std::span<const Body> bodies);
inline std::vector<std::uint32_t> tet_corners_of_nodes(const Model& model, const Body& body) {
  return tet_corners_of_nodes(model, {&body, 1});
}

struct SolidBuffers {
  using Four = std::array<std::uint32_t, 4>;

  SolidParams layout;
  gpu::RawBuffer params;  // a uniform
  gpu::Buffer<Four> corners;
  gpu::Buffer<Vec4f>
      rests;  // three a tetrahedron: the slopes of its last three corners [1/m]; w of the first [m³]

  /// Errors  Limit, OutOfMemory.
  static Result<SolidBuffers> create(gpu::Device& device, const Model& model, const Body& body) {
    return create(device, model, body, body.first_vertex, 0);
  }
  /// Of one of several bodies that kernels have together, whose nodes count from vertex `first`.
  static Result<SolidBuffers> create(gpu::Device& device, const Model& model, const Body& body,
                                     std::uint32_t first, std::uint32_t first_tet);
};

}  // namespace weft
