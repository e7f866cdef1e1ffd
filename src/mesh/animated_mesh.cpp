#include "mesh/animated_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/glb.hpp"
#include "mesh/gltf_accessor.hpp"
#include "mesh/gltf_values.hpp"
#include "mesh/gzip.hpp"
#include "mesh/text_cursor.hpp"

namespace weft::mesh {
namespace {

/// A matrix of 16 numbers, column by column. Errors  Input: its last row is not 0 0 0 1, or a number is not finite.
Result<Affine> inverse_bind_of(const GltfAccessor& matrices, std::uint64_t i, const std::string& path) {
  std::array<double, 16> m{};
  for (std::uint32_t k = 0; k < 16; ++k) m[k] = matrices.value(i, k);
  for (const double number : m)
    if (!std::isfinite(number))
      return input_error("%s: matrix %llu has a number that is not finite.", path.c_str(),
                         static_cast<unsigned long long>(i));
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || std::abs(m[15] - 1) > 1e-6)
    return input_error("%s: matrix %llu has the last row %g %g %g %g; it must be 0 0 0 1.", path.c_str(),
                       static_cast<unsigned long long>(i), m[3], m[7], m[11], m[15]);
  return Affine{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
}

}  // namespace

Result<AnimatedMesh> AnimatedMesh::read(std::span<const std::byte> bytes) {
  WEFT_TRY(glb, split_glb(bytes));
  AnimatedMesh made;
  WEFT_SET(made.parts_, read_glb_parts(glb, bytes.size(), true));
  WEFT_CHECK(check_mesh({made.parts_.positions, made.parts_.triangles}));
  WEFT_SET(made.animations_,
           gltf_animations(glb, made.parts_.nodes,
                           std::min<std::uint64_t>(kMaxMeshBytes, kMaxGlbGrowth * bytes.size())));
  WEFT_CHECK(made.read_skins(glb));
  WEFT_CHECK(made.check_joints());
  return made;
}

Result<void> AnimatedMesh::read_skins(const GlbChunks& glb) {
  WEFT_TRY(list, entries(glb.json, "", "skins"));
  skins_.resize(list->size());
  for (const SceneNode& node : parts_.nodes) {
    if (!node.skin || !node.mesh) continue;
    WEFT_TRY(skin, entry(glb.json, "skins", *node.skin, path_of_node(node) + ".skin"));
    static_cast<void>(skin);
    if (skins_[static_cast<std::size_t>(*node.skin)].empty())
      WEFT_CHECK(read_skin(glb, *node.skin, path_of_node(node) + ".skin"));
  }
  return {};
}

Result<void> AnimatedMesh::read_skin(const GlbChunks& glb, std::uint64_t number, const std::string& who) {
  WEFT_TRY(skin, entry(glb.json, "skins", number, who));
  const std::string path = path_of_index("skins", static_cast<std::size_t>(number));
  WEFT_TRY(joints, entries(*skin, path, "joints"));
  if (joints->empty()) return input_error("%s.joints is empty or missing.", path.c_str());
  std::optional<GltfAccessor> matrices;
  if (skin->find("inverseBindMatrices") != nullptr) {
    WEFT_TRY(index, whole_number(*skin, path, "inverseBindMatrices", kMostIndex));
    WEFT_TRY(found, GltfAccessor::find(glb, index, path + ".inverseBindMatrices", GltfKind::Matrices));
    if (found.count() < joints->size())
      return input_error("%s has %zu joints, but %llu matrices.", path.c_str(), joints->size(),
                         static_cast<unsigned long long>(found.count()));
    matrices = found;
  }
  std::map<std::uint64_t, std::size_t> places;
  for (std::size_t n = 0; n < parts_.nodes.size(); ++n) places[parts_.nodes[n].number] = n;
  std::vector<Joint>& made = skins_[static_cast<std::size_t>(number)];
  for (std::size_t j = 0; j < joints->size(); ++j) {
    const Json& index = (*joints)[j];
    const auto place = index.kind == Json::Kind::Number && index.number >= 0 && index.number <= kMostIndex &&
                               index.number == std::floor(index.number)
                           ? places.find(static_cast<std::uint64_t>(index.number))
                           : places.end();
    if (place == places.end())
      return input_error("%s is %s, which is no node of the scene.",
                         path_of_index(path + ".joints", j).c_str(), describe(index).c_str());
    Joint joint{place->second, {}};
    if (matrices) WEFT_SET(joint.inverse_bind, inverse_bind_of(*matrices, j, path + ".inverseBindMatrices"));
    made.push_back(joint);
  }
  return {};
}

Result<void> AnimatedMesh::check_joints() const {
  for (const GlbRange& range : parts_.ranges) {
    if (!range.first_binding) continue;
    const SceneNode& node = parts_.nodes[range.node];
    const std::size_t count = skins_[static_cast<std::size_t>(*node.skin)].size();
    for (std::size_t v = 0; v < range.count; ++v)
      for (const std::uint16_t joint : parts_.bindings[*range.first_binding + v].joints)
        if (joint >= count)
          return input_error("Vertex %zu of accessors[%llu] names joint %u, but skins[%llu] has %zu, from 0.",
                             v, static_cast<unsigned long long>(range.accessor), joint,
                             static_cast<unsigned long long>(*node.skin), count);
  }
  return {};
}

Result<const GltfAnimation*> AnimatedMesh::animation(const std::string& name) const {
  if (animations_.empty()) return input_error("The file has no animation.");
  if (name.empty()) return &animations_.front();
  std::string names;
  for (const GltfAnimation& one : animations_) {
    if (one.name == name) return &one;
    names += (names.empty() ? "\"" : ", \"") + quoted(one.name) + "\"";
  }
  return input_error("The file has no animation \"%s\"; it has %s.", quoted(name).c_str(), names.c_str());
}

std::size_t AnimatedMesh::size() const {
  std::size_t joints = 0;
  for (const GlbRange& range : parts_.ranges)
    if (range.first_binding)
      joints += skins_[static_cast<std::size_t>(*parts_.nodes[range.node].skin)].size();
  return parts_.positions.size() + parts_.nodes.size() + joints;
}

std::vector<Affine> AnimatedMesh::nodes_at(const GltfAnimation& animation, double time) const {
  std::vector<NodeParts> parts;
  parts.reserve(parts_.nodes.size());
  for (const SceneNode& node : parts_.nodes) parts.push_back(node.parts);
  animation.move(time, parts);
  return placements(parts_.nodes, parts);
}

std::vector<Affine> AnimatedMesh::joints_at(const GlbRange& range, const std::vector<Affine>& nodes) const {
  std::vector<Affine> joints;
  if (range.first_binding)
    for (const Joint& joint : skins_[static_cast<std::size_t>(*parts_.nodes[range.node].skin)])
      joints.push_back(composed(nodes[joint.node], joint.inverse_bind));
  return joints;
}

Result<std::vector<Vec3f>> AnimatedMesh::placed(const std::vector<Affine>& nodes) const {
  std::vector<Vec3f> positions = parts_.positions;
  for (const GlbRange& range : parts_.ranges) {
    const std::vector<Affine> joints = joints_at(range, nodes);
    for (std::size_t v = 0; v < range.count; ++v) {
      Vec3f& position = positions[range.first + v];
      const Vec3d own = position.to<double>();
      Vec3d there;
      if (range.first_binding) {
        const Binding& binding = parts_.bindings[*range.first_binding + v];
        for (std::size_t k = 0; k < 4; ++k)
          there += static_cast<double>(binding.weights[k]) * joints[binding.joints[k]].point(own);
      } else {
        there = nodes[range.node].point(own);
      }
      WEFT_CHECK(check_coordinates(there, range, v, parts_.nodes[range.node]));
      position = there.to<float>();
    }
  }
  return positions;
}

Result<std::vector<Vec3f>> AnimatedMesh::places(const GltfAnimation& animation, double time) const {
  return placed(nodes_at(animation, time));
}

Result<TriangleMesh> AnimatedMesh::posed(const GltfAnimation& animation, double time) const {
  const std::vector<Affine> nodes = nodes_at(animation, time);
  WEFT_TRY(positions, placed(nodes));
  TriangleMesh mesh{std::move(positions), parts_.triangles};
  // Of a skin, by the joint that counts most at its first vertex: its own node places nothing.
  const auto mirrored = [&](const GlbRange& range) {
    if (!range.first_binding || range.count == 0) return nodes[range.node].determinant() < 0;
    const Binding& binding = parts_.bindings[*range.first_binding];
    const auto most =
        std::max_element(binding.weights.begin(), binding.weights.end()) - binding.weights.begin();
    return joints_at(range, nodes)[binding.joints[static_cast<std::size_t>(most)]].determinant() < 0;
  };
  parts_.turn_where(mirrored, mesh.triangles);
  return mesh;
}

}  // namespace weft::mesh
