#include "mesh/tet_mesh.hpp"

#include <algorithm>

namespace weft::mesh {
namespace {

constexpr std::array<std::array<std::size_t, 3>, 4> kSides = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Of a cell's corners, which have the bits of x, y and z: four at corners of one sort, one between the others.
constexpr std::array<std::array<std::uint32_t, 4>, 5> kOfCell = {
    {{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 1, 4, 7}, {6, 4, 2, 7}, {1, 2, 4, 7}}};

}  // namespace

double six_volumes(const std::array<Vec3d, 4>& corners) {
  const auto& [a, b, c, d] = corners;
  return dot(cross(b - a, c - a), d - a);
}

std::vector<Triangle> boundary(std::span<const Tet> tets) {
  struct Face {
    Triangle sorted{}, triangle{};
  };
  std::vector<Face> faces;
  faces.reserve(4 * tets.size());
  for (const Tet& tet : tets)
    for (const auto& side : kSides) {
      Face face;
      face.triangle = {tet[side[0]], tet[side[1]], tet[side[2]]};
      face.sorted = face.triangle;
      std::sort(face.sorted.begin(), face.sorted.end());
      faces.push_back(face);
    }
  std::stable_sort(faces.begin(), faces.end(),
                   [](const Face& a, const Face& b) { return a.sorted < b.sorted; });
  std::vector<Triangle> found;
  for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
    while (end < faces.size() && faces[end].sorted == faces[begin].sorted) ++end;
    if (end == begin + 1) found.push_back(faces[begin].triangle);
  }
  return found;
}

TetMesh block(const std::array<std::uint32_t, 3>& cells, const Vec3d& size) {
  const auto& [nx, ny, nz] = cells;
  TetMesh made;
  const auto place = [](std::uint32_t i, std::uint32_t n) { return static_cast<double>(i) / n - 0.5; };
  for (std::uint32_t k = 0; k <= nz; ++k)
    for (std::uint32_t j = 0; j <= ny; ++j)
      for (std::uint32_t i = 0; i <= nx; ++i)
        made.positions.push_back(
            Vec3d{size.x * place(i, nx), size.y * place(j, ny), size.z * place(k, nz)}.to<float>());
  for (std::uint32_t k = 0; k < nz; ++k)
    for (std::uint32_t j = 0; j < ny; ++j)
      for (std::uint32_t i = 0; i < nx; ++i) {
        const std::uint32_t mirror =
            (i + j + k) % 2;  // along x, so that sides of neighbours have one diagonal
        for (const auto& tet : kOfCell) {
          Tet nodes{};
          for (std::size_t c = 0; c < 4; ++c) {
            const std::uint32_t corner = tet[c] ^ mirror;
            nodes[c] =
                ((k + (corner >> 2U)) * (ny + 1) + j + (corner >> 1U & 1U)) * (nx + 1) + i + (corner & 1U);
          }
          std::array<Vec3d, 4> corners;
          for (std::size_t c = 0; c < 4; ++c) corners[c] = made.positions[nodes[c]].to<double>();
          if (six_volumes(corners) < 0) std::swap(nodes[2], nodes[3]);
          made.tets.push_back(nodes);
        }
      }
  return made;
}

}  // namespace weft::mesh
