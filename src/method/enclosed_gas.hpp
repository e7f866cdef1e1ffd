#pragma once

#include <vector>

#include "gpu/dispatch.hpp"
#include "method/solver.hpp"

namespace weft {

/// Mirror of Gas in src/method/gas.wgsl.
struct Gas {
  std::uint32_t first_vertex = 0;
  std::uint32_t first_chunk = 0;
  std::uint32_t chunk_count = 0;
  float rest_volume = 0;        // [m³]
  float rest_pressure = 0;      // [Pa]
  float rest_gauge = 0;         // [Pa]
  float volume = 0, gauge = 0;  // in this substep [m³], [Pa]
};

/// Mirror of GasChunk in src/method/gas.wgsl.
struct GasChunk {
  std::uint32_t gas = 0;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

inline constexpr std::uint32_t kGasChunk = 64;  // nodes; mirror: src/method/gas.wgsl

/// The gas in closed cloths: its pressures in a substep, from the places of the nodes alone. Without gas it records
/// nothing.
/// Source  docs/pressure.md.
/// Reads   steps; position[parity] [m], velocity[parity] [m/s].
/// Writes  gases, slopes: what src/method/gas_force.wgsl reads.
class EnclosedGas {
 public:
  /// Where its places are: those at the start of the substep, or where the velocities there would take them by its end.
  enum class At { Start, Ahead };
  /// Errors  Shader, Limit, OutOfMemory.
  static Result<EnclosedGas> create(const SolverInputs& inputs, At at);
  void record(gpu::ComputePass& pass) const;
  bool any() const { return gases_.size() > 0; }

  const gpu::Buffer<Gas>& gases() const { return gases_; }
  const gpu::Buffer<Vec4f>& slopes() const { return slopes_; }

 private:
  gpu::Buffer<std::uint32_t> corners_;
  gpu::Buffer<GasChunk> chunks_;
  gpu::Buffer<Gas> gases_;
  gpu::Buffer<Vec4f> slopes_;   // by how much a volume grows with a node [m²]; w: 1 + its gas, 0: none
  gpu::Buffer<float> volumes_;  // of chunks [m³]
  gpu::Dispatch volume_, pressure_;
};

}  // namespace weft
