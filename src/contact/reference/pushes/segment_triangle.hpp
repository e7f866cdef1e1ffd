// The narrow phase in double: the result that triangle_pair.wgsl must have, and the cases where f32 may differ.
#pragma once

#include "base/vec.hpp"

namespace weft::reference {

struct TrianglePoints {
  Vec3d a, b, c;  // [m]
};

/// Ambiguous: f32 may find either. Every other verdict is one that f32 must share.
enum class Verdict { Miss, Ambiguous, Hit };

/// The segment from `from` to `to` against a triangle, by the signs of the determinants a, ua, va, ta.
/// u = 0, v = 0, u + v = 1 hit; the segment's ends and parallel segments miss.
///
/// The f32 test compares each determinant, whose error is below e = 49 * 2^-24 M, with a tolerance t = 64 *
/// 2^-24 M (M: the product of the three vectors' largest components). It takes x for >= 0 if x + error >= -t:
/// certain for x >= 0, impossible for x < -2 t. It takes x for > 0 if x + error > t: certain for x > 2 t,
/// impossible for x <= 0. Between those two the verdict is Ambiguous. Double's own error, 2^-53 M, is lost
/// between e and t.
Verdict segment_triangle(const Vec3d& from, const Vec3d& to, const TrianglePoints& triangle);

/// The six edges of two triangles, each against the other triangle.
Verdict triangle_pair(const TrianglePoints& a, const TrianglePoints& b);

}  // namespace weft::reference
