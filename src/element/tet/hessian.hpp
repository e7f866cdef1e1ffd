// How the stress of a tetrahedron changes with F, without what could make that indefinite. In double.
// Source: docs/bodies.md, All nodes at once.
#pragma once

#include "element/tet/jacobi.hpp"
#include "element/tet/law.hpp"

namespace weft::tet {

/// F = U Σ Vᵀ by two rotations: of what is inside out a stretch is negative.
struct Frame {
  Mat3 u, v;
  std::array<double, 3> stretches{};
};
Frame frame_of(const Mat3& f);

/// ∂P/∂F in such a frame, with dF = U A Vᵀ: P changes by U B Vᵀ, B_pp = Σ_q stretch_pq A_qq and, of two different
/// axes, B_pq = straight_pq A_pq + crossed_pq A_qp [Pa].
struct Hessian {
  Square<3> stretch{}, straight{}, crossed{};

  friend Hessian operator+(const Hessian& a, const Hessian& b);
  friend Hessian operator*(double s, const Hessian& a);
};
/// Of the energy. Its eigenvalues that are negative are 0 here (Smith, de Goes and Kim 2019).
Hessian positive_hessian(const Law& law, const Frame& frame);
/// That of a step that first leads F by `way`: where two axes are pressed, here or by this Hessian there, they resist
/// being turned by the stress that they have there, as if it pulled. Equation 5a.
Hessian held_hessian(const Law& law, const Frame& frame, const Mat3& way);
/// Of damping, by the rate of F [Pa·s].
Hessian damping_hessian(const Law& law, const Frame& frame);

/// P's change for one of F.
Mat3 times(const Frame& frame, const Hessian& hessian, const Mat3& change);
/// How the force on one corner grows against the place of another [N/m].
Mat3 block(const Frame& frame, const Hessian& hessian, const Rest& rest, std::size_t row, std::size_t column);

}  // namespace weft::tet
