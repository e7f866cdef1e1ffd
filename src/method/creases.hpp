#pragma once

#include <cstdint>

#include "gpu/dispatch.hpp"
#include "method/fabric_buffers.hpp"
#include "method/solver.hpp"

namespace weft {

/// Mirror of YieldLaw in src/element/hinge/yield.wgsl.
struct YieldLawBlock {
  float curvature = 0;      // [1/m]
  float hardening = 0;      // 1
  std::uint32_t first = 0;  // of the cloth's facets among all that keep bends
  std::uint32_t padding = 0;
};
static_assert(sizeof(YieldLawBlock) == 16);

/// What a cloth's facets keep of their bends for good, taken as a substep begins. Of a cloth that keeps none it records
/// nothing.
/// Source  docs/elements.md, Creases.
/// Reads   position[parity] [m].
/// Writes  state.creases [rad, 1/m] of the cloth's triangles; the same parts behind the bends of its hinges [rad].
/// Errors  Shader, Limit, OutOfMemory.
class Creases {
 public:
  /// `bends`: of FabricBuffers::bend_count() bends of so many words each.
  static Result<Creases> create(gpu::Device& device, const Model& model, const State& state, const Body& body,
                                const FabricBuffers& fabric, const gpu::RawBuffer& bends, std::uint32_t words,
                                std::uint32_t workgroup_size);
  void record(gpu::ComputePass& pass) const;

 private:
  gpu::RawBuffer law_;  // a uniform
  gpu::Buffer<FabricBuffers::Two> parts_;
  gpu::Buffer<Vec4f> curving_;
  gpu::Dispatch measure_, yield_;
};

}  // namespace weft
