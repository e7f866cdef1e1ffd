// The smoothing of a level: Chebyshev's polynomial of D⁻¹ A, before and after the level's correction.
// Source: docs/solvers/multigrid.md, equation 8.
#pragma once

#include <cstdint>

#include "model/model.hpp"

namespace weft::multigrid {

/// What no eigenvalue of D⁻¹ A of any level exceeds: on coarse levels the most that was found is 2.8.
/// Mirror: src/method/multigrid/chebyshev.wgsl.
inline constexpr double kSmoothHigh = 2.9;
/// Of fabric and of tetrahedra no eigenvalue exceeds 4, the nodes of a hinge or a tetrahedron: with this part of the
/// inverse of its diagonal they are as those of springs.
inline constexpr double kElementDiagonalPart = kSmoothHigh / 4;

/// By default that of coarse levels. Mirror: src/method/multigrid/chebyshev.wgsl.
struct Smoothing {
  std::uint32_t sweeps = 2;                          // even
  double low = kSmoothHigh / 8, high = kSmoothHigh;  // the eigenvalues that it is for
};

/// Of a sweep, from d of the one before: d = keep d + take D⁻¹ (r - A x),  x += d.
struct Sweep {
  double keep = 0, take = 0;
};
/// Sweep `number` of a polynomial, counted from 0.
Sweep sweep_of(const Smoothing& smoothing, std::uint32_t number);

/// Bodies of one kind share kernels.
enum class CycleKind : std::uint8_t { Grid, Springs, Fabric, Tets };
CycleKind kind_of(const Body& body);

/// That of the finest level of all bodies of a kind, for the greatest eigenvalue that one of them may have. `step`: the
/// length of a substep [s].
Smoothing finest_smoothing(const Model& model, CycleKind kind, double step);

}  // namespace weft::multigrid
