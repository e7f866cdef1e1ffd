#pragma once

#include "element/neighbours.hpp"
#include "model/spring_network.hpp"
#include "solver/solver.hpp"

namespace weft {

/// Mirror of PowerParams in shaders/mass_spring/apply_network.wgsl.
struct PowerParams {
  std::uint32_t count = 0, use_damping = 0;
  std::uint32_t padding[2] = {};  // to a multiple of 16 bytes
};
/// Elements a block of the fixed-tree sum of squares, one workgroup.
inline constexpr std::uint32_t kNormBlock = 256;

/// The largest eigenvalues of M^-1 K and M^-1 C at rest, by power iteration on the GPU: K (stiffness) and C
/// (damping) sum k n n^T and c n n^T over the springs. Iterates x <- A x / |A x| with A = M^-1/2 K M^-1/2,
/// `iterations` times from a seeded random start; |A x| approaches the largest eigenvalue from below. Errors
/// Shader, Limit, OutOfMemory, DeviceLost.
Result<NetworkSpectrum> find_spectrum(gpu::Device& device, const SpringNetwork& network,
                                      std::uint32_t iterations = 192);

/// The least of the limits of the model's cloths.
Result<StepLimit> mass_spring_step_limit(gpu::Device& device, const HostModel& model, double drag);

}  // namespace weft
