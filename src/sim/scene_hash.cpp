#include "sim/scene_hash.hpp"

#include <span>
#include <vector>

#include "base/state_hash.hpp"

namespace weft::sim {
namespace {

/// Hashes of parts, to be hashed together.
class PartHashes {
 public:
  explicit PartHashes(std::uint64_t first) : parts_{first} {}
  template <class Element>
  void add(const std::vector<Element>& list) {
    parts_.push_back(list.size());
    parts_.push_back(bytes_hash(std::as_bytes(std::span(list))));
  }
  std::uint64_t all() const { return bytes_hash(std::as_bytes(std::span(parts_))); }

 private:
  std::vector<std::uint64_t> parts_;
};

}  // namespace

std::uint64_t scene_hash(const scene::Scene& scene, const Assets& assets) {
  PartHashes hashes(scene.content);
  for (const auto* meshes : {&assets.cloths, &assets.objects})
    for (const mesh::TriangleMesh& mesh : *meshes) {
      hashes.add(mesh.positions);
      hashes.add(mesh.triangles);
    }
  for (const mesh::TetMesh& solid : assets.solids) {
    hashes.add(solid.positions);
    hashes.add(solid.tets);
  }
  for (const mesh::Deformation& deformation : assets.deformations) {
    hashes.add(deformation.times.times);
    for (const auto& shape : deformation.shapes) hashes.add(shape);
  }
  return hashes.all();
}

}  // namespace weft::sim
