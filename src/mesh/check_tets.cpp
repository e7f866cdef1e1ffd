#include "mesh/check_tets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft::mesh {
namespace {

/// A side of a tetrahedron by its sorted vertices, and whether these face into it.
struct TetFace {
  Triangle nodes{};
  std::uint32_t tet : 31 = 0;
  std::uint32_t inward : 1 = 0;
};

Result<void> check_counts(const TetMesh& mesh) {
  // A face has its tetrahedron in 31 bits.
  constexpr std::size_t kMaxNodes = std::numeric_limits<std::uint32_t>::max(), kMaxTets = kMaxNodes / 2;
  if (mesh.tets.empty()) return input_error("The mesh has no tetrahedra.");
  if (mesh.positions.size() > kMaxNodes || mesh.tets.size() > kMaxTets)
    return input_error("The mesh has %zu vertices and %zu tetrahedra, more than the limits of %zu and %zu.",
                       mesh.positions.size(), mesh.tets.size(), kMaxNodes, kMaxTets);
  return {};
}

Result<void> check_coordinates(const TetMesh& mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      if (const float value = mesh.positions[i][axis]; !std::isfinite(value))
        return input_error("Vertex %zu has the coordinate %g, which is not finite.", i,
                           static_cast<double>(value));
  return {};
}

Result<void> check_names(const TetMesh& mesh) {
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t vertex = mesh.tets[t][k];
      if (vertex >= mesh.positions.size())
        return input_error("Tetrahedron %zu names vertex %u, but the mesh has only %zu vertices.", t, vertex,
                           mesh.positions.size());
      for (std::size_t other = 0; other < k; ++other)
        if (mesh.tets[t][other] == vertex)
          return input_error("Tetrahedron %zu names vertex %u twice.", t, vertex);
    }
  return {};
}

Result<void> turn(TetMesh& mesh) {
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    Tet& tet = mesh.tets[t];
    std::array<Vec3d, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = mesh.positions[tet[k]].to<double>();
    double longest = 0;
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t other = 0; other < k; ++other)
        longest = std::max(longest, length(corners[k] - corners[other]));
    const double volumes = six_volumes(corners), least = kFlatTet * longest * longest * longest;
    if (!(std::abs(volumes) > least))
      return input_error(
          "Tetrahedron %zu is flat, so that it has no strain: six times its volume is %g m^3, not over the "
          "%g m^3 of rounding errors in its longest edge of %g m.",
          t, std::abs(volumes), least, longest);
    if (volumes < 0) std::swap(tet[2], tet[3]);
  }
  return {};
}

TetFace face_of(const TetMesh& mesh, std::size_t t, std::size_t without) {
  TetFace face;
  face.tet = static_cast<std::uint32_t>(t) & 0x7FFFFFFFU;
  std::size_t filled = 0;
  for (std::size_t k = 0; k < 4; ++k)
    if (k != without) face.nodes[filled++] = mesh.tets[t][k];
  bool inward = without % 2 == 1;  // with vertex 0 or 2 left out, the others in their order face outward
  const auto order = [&](std::size_t a, std::size_t b) {
    if (face.nodes[a] < face.nodes[b]) return;
    std::swap(face.nodes[a], face.nodes[b]);
    inward = !inward;
  };
  order(0, 1), order(1, 2), order(0, 1);
  face.inward = inward ? 1 : 0;
  return face;
}

Result<void> check_faces(const TetMesh& mesh) {
  std::vector<TetFace> faces;
  faces.reserve(4 * mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k) faces.push_back(face_of(mesh, t, k));
  std::sort(faces.begin(), faces.end(), [](const TetFace& a, const TetFace& b) {
    return a.nodes != b.nodes ? a.nodes < b.nodes : a.tet < b.tet;
  });
  for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
    while (end < faces.size() && faces[end].nodes == faces[begin].nodes) ++end;
    const Triangle& nodes = faces[begin].nodes;
    if (end - begin > 2)
      return input_error("The face of vertices %u, %u and %u belongs to %zu tetrahedra, more than 2.",
                         nodes[0], nodes[1], nodes[2], end - begin);
    if (end - begin == 2 && faces[begin].inward == faces[begin + 1].inward)
      return input_error(
          "Tetrahedra %u and %u lie on the same side of their face of vertices %u, %u and %u, one in the "
          "other.",
          unsigned{faces[begin].tet}, unsigned{faces[begin + 1].tet}, nodes[0], nodes[1], nodes[2]);
  }
  return {};
}

void drop_unused(TetMesh& mesh) {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh.positions.size(), kUnused);
  for (const Tet& tet : mesh.tets)
    for (const std::uint32_t vertex : tet) number[vertex] = 0;
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == kUnused) continue;
    mesh.positions[kept] = mesh.positions[i];
    number[i] = kept++;
  }
  mesh.positions.resize(kept);
  for (Tet& tet : mesh.tets)
    for (std::uint32_t& vertex : tet) vertex = number[vertex];
}

}  // namespace

Result<void> check_tets(TetMesh& mesh) {
  WEFT_CHECK(check_counts(mesh));
  WEFT_CHECK(check_coordinates(mesh));
  WEFT_CHECK(check_names(mesh));
  WEFT_CHECK(turn(mesh));
  WEFT_CHECK(check_faces(mesh));
  drop_unused(mesh);
  return {};
}

}  // namespace weft::mesh
