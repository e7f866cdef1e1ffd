#pragma once

#include "base/vec.hpp"

namespace weft {

/// Of a rod's cross-section, by its stiffness for bending over its width.
struct RodSection {
  double in_plane = 1;  // bending within the plane of the width; of a strip of width w E w²/12B
  double twist = 1;     // of a strip 4 D33/B
  // Over what length twist sets in, from a clamp that keeps the width straight; of a strip w sqrt(B/48 D33).
  double warping = 0;  // [the rod's length]
};

/// A rod, or a narrow strip, that is clamped at one end and bends and twists under its own weight.
/// Kirchhoff's rod (1859), which does not stretch: with directors d1 across the width, d2 normal to it, d3 along,
///   m = K1 d1 + c K2 d2 + t K3 / (1 - exp(-s/λ)) d3,   dm/ds = -d3 x n,   m(1) = 0
///   n = G (1 - s) g,   d(d_i)/ds = K x d_i
/// in units of its length and its bending stiffness; G = w L³/B. λ is that of Vlasov (1940): a section that twists
/// warps. At the clamp d1, d2, d3 are x, y and z. Solved from the free end, whose directors are sought (Newton's
/// method), with weight added little by little, so that of several solutions it is the one to which the rod bends from
/// straight.
class KirchhoffRod {
 public:
  Vec3d tip;  // of the free end from the clamp, by the length

  /// `down` is where weight pulls, as a unit vector in the frame of the clamp. It must turn the rod out of its planes
  /// of symmetry a little where the rod would buckle.
  KirchhoffRod(double load, const Vec3d& down, const RodSection& section);
};

}  // namespace weft
