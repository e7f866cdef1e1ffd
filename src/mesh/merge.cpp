#include "mesh/merge.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace weft::mesh {
namespace {

using Key = std::array<std::uint32_t, 3>;  // the bits of a vertex

struct Entry {
  Key key;
  std::uint32_t index;
};

Key key_of(const Vec3f& p) {
  const Vec3f plain{p.x + 0.0F, p.y + 0.0F, p.z + 0.0F};  // -0 becomes 0
  Key key;
  std::memcpy(key.data(), &plain, sizeof key);
  return key;
}

}  // namespace

// Sorted and not hashed: a file made to collide would cost a hash table quadratic time.
void merge_vertices(TriangleMesh& mesh) {
  std::vector<Entry> entries(mesh.positions.size());
  for (std::uint32_t i = 0; i < entries.size(); ++i) entries[i] = {key_of(mesh.positions[i]), i};
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.key != b.key ? a.key < b.key : a.index < b.index;
  });
  std::vector<std::uint32_t> vertex(entries.size());  // before -> the first with the same bits, before
  for (std::size_t i = 0; i < entries.size(); ++i)
    vertex[entries[i].index] =
        i > 0 && entries[i].key == entries[i - 1].key ? vertex[entries[i - 1].index] : entries[i].index;
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < vertex.size(); ++i) {  // now to where that stands afterwards
    if (vertex[i] != i) {
      vertex[i] = vertex[vertex[i]];
      continue;
    }
    mesh.positions[count] = mesh.positions[i];
    vertex[i] = count++;
  }
  mesh.positions.resize(count);
  for (Triangle& triangle : mesh.triangles)
    for (std::uint32_t& corner : triangle) corner = vertex[corner];
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
