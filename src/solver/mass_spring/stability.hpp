#pragma once

#include "element/neighbours.hpp"
#include "solver/solver.hpp"

namespace weft {

/// Mirror of PowerParams in shaders/mass_spring/apply_network.wgsl.
struct PowerParams {
  std::uint32_t count = 0, use_damping = 0;
  std::uint32_t padding[2] = {};  // to a multiple of 16 bytes
};
/// Elements a block of the fixed-tree sum of squares, one workgroup.
inline constexpr std::uint32_t kNormBlock = 256;

/// The network of springs whose highest frequency is asked for.
struct SpringNetwork {
  std::vector<Vec4f> position;  // [m]; w: inverse mass [1/kg]
  std::vector<Spring> springs;  // nodes count from 0
};

/// The part of a cloth that decides its highest frequency: a mesh whole; of a grid at most 64 x 64 nodes with
/// the same spacing, mass and springs, since the highest frequency of a lattice of N x N nodes is within (π /
/// 2N)² of that of any larger one (0.06 % at N = 64). Held nodes are taken as free, which can only raise it
/// (eigenvalues interlace).
SpringNetwork stiffest_part(const HostModel& model, const ClothModel& cloth);

/// The largest eigenvalues of M^-1 K and M^-1 C at rest, by power iteration on the GPU: K (stiffness) and C
/// (damping) sum k n n^T and c n n^T over the springs. Iterates x <- A x / |A x| with A = M^-1/2 K M^-1/2,
/// `iterations` times from a seeded random start; |A x| approaches the largest eigenvalue from below. Errors
/// Shader, Limit, OutOfMemory, DeviceLost.
Result<NetworkSpectrum> find_spectrum(gpu::Device& device, const SpringNetwork& network,
                                      std::uint32_t iterations = 192);

/// Semi-implicit Euler with damping taken at the old velocity is stable for h² λ + 2 h μ < 4, where λ is the
/// largest eigenvalue of M^-1 K and μ that of M^-1 C plus the drag: h < (√(μ² + 4 λ) - μ) / λ. Source:
/// docs/solvers/mass_spring.md, equation 7.
double largest_stable_step(double stiffness, double damping);

/// The least of the limits of cloths with these spectra.
StepLimit least_step_limit(std::vector<NetworkSpectrum> cloths, double drag);

/// The least of the limits of the model's cloths.
Result<StepLimit> mass_spring_step_limit(gpu::Device& device, const HostModel& model, double drag);

}  // namespace weft
