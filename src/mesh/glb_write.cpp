#include "mesh/glb.hpp"
#include "mesh/glb_animation.hpp"

namespace weft::mesh {

std::vector<std::byte> write_glb(const TriangleMesh& mesh, const VertexAttributes& attributes) {
  const GlbAnimation file(mesh, attributes, {}, {});
  std::vector<std::byte> bytes = file.begin();
  const std::vector<std::byte> arrays = file.first();
  bytes.insert(bytes.end(), arrays.begin(), arrays.end());
  return bytes;
}

}  // namespace weft::mesh
