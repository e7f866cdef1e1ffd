#include "mesh/gltf_nodes.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "mesh/gltf_values.hpp"

namespace weft::mesh {
namespace {

struct Waiting {
  std::uint64_t node;
  std::optional<std::size_t> parent;
};

Result<Affine> from_matrix(const std::vector<double>& m, const std::string& path) {
  if (m[3] != 0.0 || m[7] != 0.0 || m[11] != 0.0 || m[15] != 1.0)
    return input_error("%s.matrix has the last row %g %g %g %g; it must be 0 0 0 1.", path.c_str(), m[3],
                       m[7], m[11], m[15]);
  return Affine{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
}

Result<void> read_transform(const Json& node, const std::string& path, SceneNode& into) {
  WEFT_TRY(matrix, numbers(node, path, "matrix", 16));
  if (!matrix.empty()) {
    WEFT_TRY(placement, from_matrix(matrix, path));
    into.matrix = placement;
    return {};
  }
  WEFT_SET(into.parts.translation, numbers(node, path, "translation", 3));
  WEFT_SET(into.parts.rotation, numbers(node, path, "rotation", 4));
  WEFT_SET(into.parts.scale, numbers(node, path, "scale", 3));
  const std::vector<double>& q = into.parts.rotation;
  if (!q.empty() && !(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] > 0.0))
    return input_error("%s.rotation is [%g, %g, %g, %g]; it must be a quaternion of length 1.", path.c_str(),
                       q[0], q[1], q[2], q[3]);
  return {};
}

// Puts the nodes of a list on the stack, the first on top.
Result<void> push(std::vector<Waiting>& stack, const Json& owner, const std::string& path, const char* name,
                  std::optional<std::size_t> parent) {
  WEFT_TRY(list, entries(owner, path, name));
  for (std::size_t i = list->size(); i-- > 0;) {
    const Json& index = (*list)[i];
    if (index.kind != Json::Kind::Number || !(index.number >= 0.0 && index.number <= kMostIndex) ||
        index.number != std::floor(index.number))
      return input_error("%s is %s; it must be the number of a node.",
                         path_of_index(path_of_key(path, name), i).c_str(), describe(index).c_str());
    stack.push_back({static_cast<std::uint64_t>(index.number), parent});
  }
  return {};
}

Result<const Json*> default_scene(const Json& document, std::string& path) {
  WEFT_TRY(index, whole_number(document, "", "scene", kMostIndex, 0));
  WEFT_TRY(scene, entry(document, "scenes", index, "scene"));
  path = path_of_index("scenes", static_cast<std::size_t>(index));
  return scene;
}

}  // namespace

Affine composed(const Affine& outer, const Affine& inner) {
  return {outer.direction(inner.x), outer.direction(inner.y), outer.direction(inner.z),
          outer.point(inner.origin)};
}

Affine transform_of(const NodeParts& parts) {
  const auto& [t, q, s] = parts;
  Affine result;
  if (!q.empty()) {
    const Vec3d axis{q[0], q[1], q[2]};
    const double norm = dot(axis, axis) + q[3] * q[3];
    for (Vec3d* column : {&result.x, &result.y, &result.z}) {  // q v q⁻¹, multiplied out
      const Vec3d turn = (2.0 / norm) * cross(axis, *column);
      *column = *column + q[3] * turn + cross(axis, turn);
    }
  }
  if (!s.empty()) {
    result.x *= s[0];
    result.y *= s[1];
    result.z *= s[2];
  }
  if (!t.empty()) result.origin = {t[0], t[1], t[2]};
  return result;
}

Result<std::vector<SceneNode>> scene_nodes(const Json& document) {
  std::string path;
  WEFT_TRY(scene, default_scene(document, path));
  std::vector<Waiting> stack;
  WEFT_CHECK(push(stack, *scene, path, "nodes", {}));
  WEFT_TRY(nodes, entries(document, "", "nodes"));
  std::vector<bool> reached(nodes->size(), false);
  std::vector<SceneNode> result;
  while (!stack.empty()) {  // no recursion: a file can be as deep as it is long
    const Waiting here = stack.back();
    stack.pop_back();
    WEFT_TRY(node, entry(document, "nodes", here.node, "A node of " + path));
    if (reached[static_cast<std::size_t>(here.node)])
      return input_error("nodes[%llu] is reached twice; the nodes of a scene are trees.",
                         static_cast<unsigned long long>(here.node));
    reached[static_cast<std::size_t>(here.node)] = true;
    const std::string name = path_of_index("nodes", static_cast<std::size_t>(here.node));
    SceneNode one{here.node, here.parent, {}, {}, {}, {}};
    WEFT_CHECK(read_transform(*node, name, one));
    for (const auto& [key, number] : {std::pair{"mesh", &one.mesh}, {"skin", &one.skin}}) {
      if (node->find(key) == nullptr) continue;
      WEFT_TRY(given, whole_number(*node, name, key, kMostIndex));
      *number = given;
    }
    result.push_back(std::move(one));
    WEFT_CHECK(push(stack, *node, name, "children", result.size() - 1));
  }
  return result;
}

std::vector<Affine> placements(const std::vector<SceneNode>& nodes, const std::vector<NodeParts>& parts) {
  std::vector<Affine> all;
  all.reserve(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const Affine local = nodes[n].matrix ? *nodes[n].matrix : transform_of(parts[n]);
    all.push_back(nodes[n].parent ? composed(all[*nodes[n].parent], local) : local);
  }
  return all;
}

}  // namespace weft::mesh
