// A tetrahedron of an elastic body: constant strain, isotropic. In double.
// Source: docs/bodies.md, The laws.
#pragma once

#include <array>
#include <cstdint>

#include "base/mat3.hpp"
#include "base/vec.hpp"

namespace weft::tet {

enum class Energy : std::uint8_t {
  NeoHookean,  // stable neo-Hookean (Smith, de Goes and Kim 2018), without their logarithm
  Corotated    // linear elasticity in the frame of the nearest rotation
};

/// Both energies have Lamé's moduli where the body is at rest.
struct Law {
  Energy energy = Energy::NeoHookean;
  double mu = 0, lambda = 0;  // [Pa]
  double delay = 0;           // of Kelvin and Voigt [s]: strain ε resists as ε + delay dε/dt does

  static Law of(Energy energy, double young, double poisson, double delay);
};

/// The rotation that is nearest to F, and its mirror image never, however a tetrahedron is turned inside out.
/// Horn 1987: the eigenvector of the largest eigenvalue of a symmetric 4 x 4 matrix, by Jacobi's rotations.
Mat3 nearest_rotation(const Mat3& f);

/// Of one cubic metre at rest [J/m³].
double energy(const Law& law, const Mat3& f);
/// By F: the first Piola-Kirchhoff stress [Pa].
Mat3 stress(const Law& law, const Mat3& f);
/// What damping adds where F changes at a rate [Pa].
Mat3 damping_stress(const Law& law, const Mat3& f, const Mat3& rate);

/// A tetrahedron at rest.
struct Rest {
  double volume = 0;             // [m³]
  std::array<Vec3d, 4> slope{};  // of each corner's shape function [1/m]; they sum to zero

  static Rest of(const std::array<Vec3d, 4>& corners);
};

using Corners = std::array<Vec3d, 4>;

/// F of corners at these places [m], or its rate by their velocities [m/s].
Mat3 deformation(const Rest& rest, const Corners& corners);
/// [N]; they sum to zero and turn nothing.
Corners forces(const Rest& rest, const Mat3& stress);

/// What pulls at a corner at the end of a step, the others where they are, damped by how much the strain has changed
/// since the step began, and how fast that grows against the corner's way, without what could make it indefinite.
struct CornerPull {
  Vec3d force;   // [N]
  Mat3 hessian;  // symmetric [N/m]
};
CornerPull corner_pull(const Law& law, const Rest& rest, const Mat3& f, const Mat3& start, double rate,
                       std::size_t corner);

}  // namespace weft::tet
