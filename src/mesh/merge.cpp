#include "mesh/merge.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <vector>

namespace weft::mesh {
namespace {

using Key = std::array<std::uint32_t, 3>;  // the bits of a vertex

Key key_of(const Vec3f& p) {
  const Vec3f plain{p.x + 0.0F, p.y + 0.0F, p.z + 0.0F};  // -0 becomes 0
  Key key;
  std::memcpy(key.data(), &plain, sizeof key);
  return key;
}

// The vertices of a mesh and of its shapes, in order of their bits.
class Places {
 public:
  Places(const std::vector<Vec3f>& positions, std::span<const std::vector<Vec3f>> shapes)
      : positions_(positions), shapes_(shapes) {}

  bool before(std::uint32_t a, std::uint32_t b) const {
    const int order = compared(positions_, a, b);
    if (order != 0) return order < 0;
    for (const std::vector<Vec3f>& shape : shapes_)
      if (const int other = compared(shape, a, b); other != 0) return other < 0;
    return false;
  }

 private:
  static int compared(const std::vector<Vec3f>& positions, std::uint32_t a, std::uint32_t b) {
    const Key one = key_of(positions[a]), other = key_of(positions[b]);
    return one < other ? -1 : other < one ? 1 : 0;
  }

  const std::vector<Vec3f>& positions_;
  std::span<const std::vector<Vec3f>> shapes_;
};

}  // namespace

// Sorted and not hashed: a file made to collide would cost a hash table quadratic time.
std::size_t merge_vertices(TriangleMesh& mesh, std::span<std::vector<Vec3f>> shapes) {
  const std::size_t before = mesh.positions.size();
  const Places places(mesh.positions, shapes);
  std::vector<std::uint32_t> order(before);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (places.before(a, b)) return true;
    return !places.before(b, a) && a < b;
  });
  std::vector<std::uint32_t> vertex(before);  // before -> the first at the same place, before
  for (std::size_t i = 0; i < before; ++i)
    vertex[order[i]] = i > 0 && !places.before(order[i - 1], order[i]) ? vertex[order[i - 1]] : order[i];
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < before; ++i) {  // now to where that stands afterwards
    if (vertex[i] != i) {
      vertex[i] = vertex[vertex[i]];
      continue;
    }
    mesh.positions[count] = mesh.positions[i];
    for (std::vector<Vec3f>& shape : shapes) shape[count] = shape[i];
    vertex[i] = count++;
  }
  mesh.positions.resize(count);
  for (std::vector<Vec3f>& shape : shapes) shape.resize(count);
  for (Triangle& triangle : mesh.triangles)
    for (std::uint32_t& corner : triangle) corner = vertex[corner];
  return before - count;
}

std::size_t drop_unused_vertices(TriangleMesh& mesh) {
  constexpr std::uint32_t kUnused = ~std::uint32_t{0};
  std::vector<std::uint32_t> vertex(mesh.positions.size(), kUnused);  // before -> after
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) vertex[corner] = 0;
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < vertex.size(); ++i) {
    if (vertex[i] == kUnused) continue;
    mesh.positions[count] = mesh.positions[i];
    vertex[i] = count++;
  }
  const std::size_t dropped = mesh.positions.size() - count;
  mesh.positions.resize(count);
  for (Triangle& triangle : mesh.triangles)
    for (std::uint32_t& corner : triangle) corner = vertex[corner];
  return dropped;
}

}  // namespace weft::mesh
