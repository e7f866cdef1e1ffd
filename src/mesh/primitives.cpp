#include "mesh/primitives.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

namespace weft::mesh {

namespace {

constexpr double kPi = 3.14159265358979323846;

void add_ring(TriangleMesh& mesh, int columns, double radius, double height) {
  for (int column = 0; column < columns; ++column) {
    const double around = 2.0 * kPi * column / columns;
    mesh.positions.push_back(Vec3d{radius * std::cos(around), height, radius * std::sin(around)}.to<float>());
  }
}

// The triangles over the north pole, `rings` rings from north to south, and the south pole, which are the
// vertices in this order. Row 0 and the last are the poles. Seen from outside:
//
//     a───b    a, b: row r, columns c + 1 and c (the angle grows to the left, y is up)
//     │   │
//     d───e    d, e: row r + 1
void close_rings(TriangleMesh& mesh, int columns, int rings) {
  const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  const auto vertex = [&](int row, int column) {
    if (row == 0) return std::uint32_t{0};
    if (row > rings) return last;
    return static_cast<std::uint32_t>(1 + (row - 1) * columns + column % columns);
  };
  for (int row = 0; row <= rings; ++row)
    for (int column = 0; column < columns; ++column) {
      const std::uint32_t a = vertex(row, column + 1);
      const std::uint32_t b = vertex(row, column);
      const std::uint32_t d = vertex(row + 1, column + 1);
      const std::uint32_t e = vertex(row + 1, column);
      if (row > 0) mesh.triangles.push_back({a, d, b});      // at the pole a and b are one
      if (row < rings) mesh.triangles.push_back({b, d, e});  // at the other d and e are
    }
}

}  // namespace

TriangleMesh make_sphere(int columns, int rows) {
  assert(columns >= 3 && rows >= 2);
  TriangleMesh mesh;
  mesh.positions.push_back({0.0F, 1.0F, 0.0F});
  for (int row = 1; row < rows; ++row) {
    const double polar = kPi * row / rows;
    add_ring(mesh, columns, std::sin(polar), std::cos(polar));
  }
  mesh.positions.push_back({0.0F, -1.0F, 0.0F});
  close_rings(mesh, columns, rows - 1);
  return mesh;
}

TriangleMesh make_geodesic_sphere(int cells) {
  assert(cells >= 1);
  constexpr double kGolden = 1.6180339887498949;
  constexpr std::array<Vec3d, 12> kCorners = {{{-1, kGolden, 0},
                                               {1, kGolden, 0},
                                               {-1, -kGolden, 0},
                                               {1, -kGolden, 0},
                                               {0, -1, kGolden},
                                               {0, 1, kGolden},
                                               {0, -1, -kGolden},
                                               {0, 1, -kGolden},
                                               {kGolden, 0, -1},
                                               {kGolden, 0, 1},
                                               {-kGolden, 0, -1},
                                               {-kGolden, 0, 1}}};
  constexpr std::array<Triangle, 20> kFaces = {{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                                {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                                {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                                {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};
  TriangleMesh mesh;
  // A vertex by the corners that it is between and its part of each, which are the same in the faces that share it.
  std::map<std::array<std::pair<std::uint32_t, int>, 3>, std::uint32_t> numbers;
  const auto vertex = [&](const Triangle& face, int i, int j) {
    const std::array<int, 3> parts = {cells - i - j, i, j};
    std::array<std::pair<std::uint32_t, int>, 3> key{};
    Vec3d place;
    for (std::size_t k = 0; k < 3; ++k) {
      if (parts[k] == 0) continue;  // a key with fewer corners: the face's third is not one of an edge's
      key[k] = {face[k] + 1, parts[k]};
      place += static_cast<double>(parts[k]) * kCorners[face[k]];
    }
    std::sort(key.begin(), key.end());
    const auto [at, is_new] = numbers.emplace(key, static_cast<std::uint32_t>(mesh.positions.size()));
    if (is_new) mesh.positions.push_back((place / length(place)).to<float>());
    return at->second;
  };
  for (const Triangle& face : kFaces)
    for (int i = 0; i < cells; ++i)
      for (int j = 0; i + j < cells; ++j) {
        mesh.triangles.push_back({vertex(face, i, j), vertex(face, i + 1, j), vertex(face, i, j + 1)});
        if (i + j + 2 > cells) continue;
        mesh.triangles.push_back(
            {vertex(face, i + 1, j), vertex(face, i + 1, j + 1), vertex(face, i, j + 1)});
      }
  return mesh;
}

TriangleMesh make_capsule(double length, double radius, int columns, int rows) {
  assert(length > 0 && radius > 0 && columns >= 3 && rows >= 1);
  TriangleMesh mesh;
  const double end = 0.5 * length;
  mesh.positions.push_back(Vec3d{0, end + radius, 0}.to<float>());
  for (int row = 1; row <= rows; ++row) {
    const double polar = 0.5 * kPi * row / rows;
    add_ring(mesh, columns, radius * std::sin(polar), row == rows ? end : end + radius * std::cos(polar));
  }
  for (int row = rows; row >= 1; --row) {
    const double polar = 0.5 * kPi * row / rows;
    add_ring(mesh, columns, radius * std::sin(polar), row == rows ? -end : -end - radius * std::cos(polar));
  }
  mesh.positions.push_back(Vec3d{0, -end - radius, 0}.to<float>());
  close_rings(mesh, columns, 2 * rows);
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
