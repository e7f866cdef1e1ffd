#include "contact/reference/pushes/winding.hpp"

#include <cmath>

namespace weft::reference {

double winding_number(const Vec3d& point, const mesh::TriangleMesh& mesh) {
  constexpr double kFourPi = 12.566370614359172;
  double angle = 0;
  for (const mesh::Triangle& t : mesh.triangles) {
    const Vec3d a = mesh.positions[t[0]].to<double>() - point;
    const Vec3d b = mesh.positions[t[1]].to<double>() - point;
    const Vec3d c = mesh.positions[t[2]].to<double>() - point;
    const double la = length(a), lb = length(b), lc = length(c);
    // tan(angle / 2) = det(a, b, c) / (la lb lc + (a.b) lc + (b.c) la + (c.a) lb), equation 8
    angle +=
        2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return angle / kFourPi;
}

bool inside(const Vec3d& point, const mesh::TriangleMesh& mesh) { return winding_number(point, mesh) > 0.5; }

}  // namespace weft::reference
