// A cloth of fabric on the GPU: its elements, as every method's kernels read them, and room for their forces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "element/hinge/plate.hpp"
#include "gpu/buffer.hpp"
#include "model/cords.hpp"

namespace weft {

/// Mirror of MembraneLaw in src/element/membrane/law.wgsl.
struct MembraneLawBlock {
  Vec4f stiffness;           // C11, C12, C22, C33 [N/m]
  float delay = 0;           // [s]
  std::uint32_t energy = 0;  // membrane::Energy
  std::uint32_t padding[2] = {};
};
static_assert(sizeof(MembraneLawBlock) == 32);

/// Mirror of FabricParams in src/method/fabric_params.wgsl.
struct FabricParams {
  std::uint32_t first = 0, count = 0;
  std::uint32_t triangles = 0, hinges = 0;
  MembraneLawBlock law;
};
static_assert(sizeof(FabricParams) == 48 && offsetof(FabricParams, law) == 16);

/// Rows, each where its entries begin, one more than there are, then the entries, as kernels read both in one buffer.
std::vector<std::uint32_t> rows_then_entries(std::span<const std::uint32_t> starts,
                                             std::span<const std::uint32_t> entries);

/// Each node's triangles, hinges and cords, as places of its forces (FabricBuffers::forces): rows of nodes,
/// then their entries.
std::vector<std::uint32_t> gathers_of(const Model& model, const Body& body, std::span<const Cord> cords);

/// Of a number in f32.
std::uint32_t bits_of(double value);

struct FabricBuffers {
  using Two = std::array<std::uint32_t, 2>;
  using Four = std::array<std::uint32_t, 4>;

  FabricParams layout;
  gpu::RawBuffer params;               // a uniform
  gpu::Buffer<std::uint32_t> corners;  // of triangles
  gpu::Buffer<Vec4f> slopes;           // of triangles at rest [1/m]
  // Of hinges; empty where there is none.
  gpu::Buffer<Four> hinges;
  gpu::Buffer<float> rest_angles;  // [rad]
  // Rows of hinges, then pairs of a bend and the bits of N·m. Bends are those of hinges and, of a cloth that keeps
  // them, what each facet keeps at its three edges: `bend_count` in all.
  gpu::Buffer<Two> couplings;
  std::size_t bend_count = 0;

  // Of methods that sum forces: create_forces.
  gpu::Buffer<std::uint32_t> gathers;  // rows of nodes, then their forces
  gpu::Buffer<Vec4f> forces;           // of the corners of all triangles, of all hinges, of all cords [N]
  gpu::Buffer<float> bends;            // empty where there is no hinge [rad]
  gpu::Buffer<Cord> cords;             // empty where nothing is limited or sewn

  /// Errors  Limit, OutOfMemory.
  static Result<FabricBuffers> create(gpu::Device& device, const Model& model, const Body& body);
  Result<void> create_forces(gpu::Device& device, const Model& model, const Body& body);
};

}  // namespace weft
