#include "mesh/primitives.hpp"

#include <cassert>
#include <cmath>

namespace weft::mesh {

// Vertices: the north pole, then the rings from north to south, then the south pole. Seen from outside:
//
//     a───b    a, b: ring r, columns c + 1 and c (the angle grows to the left, y is up)
//     │   │
//     d───e    d, e: ring r + 1
TriangleMesh make_sphere(int columns, int rows) {
  assert(columns >= 3 && rows >= 2);
  constexpr double kPi = 3.14159265358979323846;
  TriangleMesh mesh;
  mesh.positions.push_back({0.0F, 1.0F, 0.0F});
  for (int row = 1; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double polar = kPi * row / rows;
      const double around = 2.0 * kPi * column / columns;
      const Vec3d p{std::sin(polar) * std::cos(around), std::cos(polar), std::sin(polar) * std::sin(around)};
      mesh.positions.push_back(p.to<float>());
    }
  mesh.positions.push_back({0.0F, -1.0F, 0.0F});

  const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  const auto vertex = [&](int row, int column) {
    if (row == 0) return std::uint32_t{0};
    if (row == rows) return last;
    return static_cast<std::uint32_t>(1 + (row - 1) * columns + column % columns);
  };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const std::uint32_t a = vertex(row, column + 1);
      const std::uint32_t b = vertex(row, column);
      const std::uint32_t d = vertex(row + 1, column + 1);
      const std::uint32_t e = vertex(row + 1, column);
      if (row > 0) mesh.triangles.push_back({a, d, b});         // at the pole a and b are one
      if (row + 1 < rows) mesh.triangles.push_back({b, d, e});  // at the other d and e are
    }
  return mesh;
}

// Vertex k is at the positive end of x, y, z where bit 0, 1, 2 of k is set:
//
//      2 ────── 3      y
//    6 ─┼──── 7 │      │
//    │  0 ────┼ 1      o── x
//    4 ────── 5       z
TriangleMesh make_box(const Vec3d& size) {
  TriangleMesh mesh;
  for (std::uint32_t k = 0; k < 8; ++k) {
    const Vec3d end{(k & 1U) != 0 ? 0.5 : -0.5, (k & 2U) != 0 ? 0.5 : -0.5, (k & 4U) != 0 ? 0.5 : -0.5};
    mesh.positions.push_back(Vec3d{end.x * size.x, end.y * size.y, end.z * size.z}.to<float>());
  }
  constexpr std::uint32_t kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5},   // x
                                          {0, 1, 5, 4}, {2, 6, 7, 3},   // y
                                          {0, 2, 3, 1}, {4, 5, 7, 6}};  // z
  for (const auto& [a, b, c, d] : kFaces) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh;
}

}  // namespace weft::mesh
