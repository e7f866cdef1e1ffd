#include "mesh/mass_moments.hpp"

#include <cmath>

namespace weft::mesh {

MassMoments mass_moments(const TriangleMesh& mesh) {
  MassMoments sums;
  if (mesh.positions.empty()) return sums;
  const Vec3d origin = mesh.positions[0].to<double>();  // near the mesh, so that little cancels
  Vec3d first;
  Mat3 second{};
  for (const Triangle& corner : mesh.triangles) {
    const Vec3d a = mesh.positions[corner[0]].to<double>() - origin,
                b = mesh.positions[corner[1]].to<double>() - origin,
                c = mesh.positions[corner[2]].to<double>() - origin;
    const double volume = dot(a, cross(b, c)) / 6;
    const Vec3d sum = a + b + c;
    sums.volume += volume;
    first += (volume / 4) * sum;
    // Of a tetrahedron with one corner at 0: V/20 (Σ x xᵀ over its corners + their sum's product with itself).
    second +=
        (volume / 20) * (Mat3::outer(a, a) + Mat3::outer(b, b) + Mat3::outer(c, c) + Mat3::outer(sum, sum));
  }
  if (!(sums.volume > 0)) return sums;
  const Vec3d mean = first / sums.volume;
  sums.center = origin + mean;
  sums.second = second + (-sums.volume) * Mat3::outer(mean, mean);
  return sums;
}

Mat3 inertia_of(const MassMoments& moments) {
  const Mat3& s = moments.second;
  return Mat3::identity(s.x.x + s.y.y + s.z.z) + (-1.0) * s;
}

PrincipalAxes principal_axes(const Mat3& symmetric) {
  Mat3 a = symmetric, axes = Mat3::identity(1);
  Vec3d* row[] = {&a.x, &a.y, &a.z};
  constexpr int kSweeps = 32;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    bool done = true;
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        const double beside = (*row[p])[q];
        if (std::abs(beside) <= 1e-15 * (std::abs((*row[p])[p]) + std::abs((*row[q])[q]))) continue;
        done = false;
        const double ratio = ((*row[q])[q] - (*row[p])[p]) / (2 * beside);
        const double tangent = (ratio < 0 ? -1 : 1) / (std::abs(ratio) + std::sqrt(ratio * ratio + 1));
        const double cosine = 1 / std::sqrt(tangent * tangent + 1), sine = tangent * cosine;
        Mat3 turn = Mat3::identity(1);
        Vec3d* turned[] = {&turn.x, &turn.y, &turn.z};
        (*turned[p])[p] = (*turned[q])[q] = cosine;
        (*turned[p])[q] = sine;
        (*turned[q])[p] = -sine;
        a = transposed(turn) * a * turn;
        axes = axes * turn;
      }
    if (done) break;
  }
  return {{a.x.x, a.y.y, a.z.z}, axes};
}

}  // namespace weft::mesh
