#include "mesh/glb_parts.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "mesh/glb.hpp"
#include "mesh/glb_chunks.hpp"
#include "mesh/gltf_accessor.hpp"
#include "mesh/gltf_nodes.hpp"
#include "mesh/gltf_values.hpp"
#include "mesh/gzip.hpp"
#include "mesh/text_cursor.hpp"

namespace weft::mesh {
namespace {

constexpr std::uint64_t kTriangles = 4, kStrip = 5, kFan = 6;  // mode of a primitive

Result<void> check_version(const Json& document) {
  const Json* asset = document.find("asset");
  const Json* version = asset != nullptr ? asset->find("version") : nullptr;
  if (version != nullptr && version->kind == Json::Kind::Text && version->text.rfind("2.", 0) == 0) return {};
  return input_error("asset.version is %s; it must be \"2.0\".",
                     version != nullptr ? quoted(version->text).c_str() : "missing");
}

// Those that change how a surface looks leave its shape alone.
Result<void> check_extensions(const Json& document) {
  WEFT_TRY(required, entries(document, "", "extensionsRequired"));
  for (const Json& name : *required) {
    const std::string_view text = name.text;
    const bool known = text.rfind("KHR_materials_", 0) == 0 || text.rfind("KHR_texture_", 0) == 0 ||
                       text.rfind("EXT_texture_", 0) == 0;
    if (!known)
      return input_error("The file requires the extension \"%s\", which is not read.", quoted(text).c_str());
  }
  return {};
}

/// Gathers the parts, primitive after primitive, within a bound on their size.
class Assembly {
 public:
  Assembly(const GlbChunks& glb, std::size_t file_size, bool skins)
      : glb_(glb),
        file_size_(file_size),
        limit_(std::min<std::uint64_t>(kMaxMeshBytes, kMaxGlbGrowth * file_size)),
        skins_(skins) {}

  Result<GlbParts> run() {
    WEFT_SET(parts_.nodes, scene_nodes(glb_.json));
    for (std::size_t n = 0; n < parts_.nodes.size(); ++n)
      if (parts_.nodes[n].mesh) WEFT_CHECK(add(n));
    return std::move(parts_);
  }

 private:
  Result<void> add(std::size_t place) {
    const SceneNode& node = parts_.nodes[place];
    WEFT_TRY(mesh, entry(glb_.json, "meshes", *node.mesh, path_of_node(node) + ".mesh"));
    const std::string path = path_of_index("meshes", static_cast<std::size_t>(*node.mesh));
    WEFT_TRY(primitives, entries(*mesh, path, "primitives"));
    ranges_.clear();
    for (std::size_t i = 0; i < primitives->size(); ++i)
      WEFT_CHECK(add_primitive((*primitives)[i], path_of_index(path + ".primitives", i), place));
    return {};
  }

  Result<void> check_room(std::uint64_t vertices, std::uint64_t triangles) {
    const std::uint64_t vertex_bytes = sizeof(Vec3f) + (skins_ ? sizeof(Binding) : 0);
    const std::uint64_t bytes = vertex_bytes * (parts_.positions.size() + vertices) +
                                sizeof(Triangle) * (parts_.triangles.size() + triangles) +
                                sizeof(GlbTriangles) * parts_.primitives.size() +
                                sizeof(GlbRange) * parts_.ranges.size();
    if (bytes <= limit_) return {};
    return input_error(
        "The scene repeats its meshes until they take over %llu bytes, the limit for a file of %zu.",
        static_cast<unsigned long long>(limit_), file_size_);
  }

  // Primitives of a mesh often share their vertices and differ in their indices.
  Result<GlbRange> add_vertices(const Json& primitive, const std::string& path, std::size_t place) {
    const Json* attributes = primitive.find("attributes");
    if (attributes == nullptr) return input_error("%s.attributes is missing.", path.c_str());
    const std::string who = path + ".attributes";
    const bool skinned = skins_ && parts_.nodes[place].skin.has_value();
    WEFT_TRY(index, whole_number(*attributes, who, "POSITION", kMostIndex));
    std::array<std::uint64_t, 3> accessors = {index, 0, 0};
    if (skinned) {
      WEFT_SET(accessors[1], whole_number(*attributes, who, "JOINTS_0", kMostIndex));
      WEFT_SET(accessors[2], whole_number(*attributes, who, "WEIGHTS_0", kMostIndex));
      if (attributes->find("JOINTS_1") != nullptr)
        return input_error("%s.JOINTS_1: more than four joints at a vertex are not read.", who.c_str());
    }
    if (const auto known = ranges_.find(accessors); known != ranges_.end()) return known->second;
    WEFT_TRY(positions, GltfAccessor::find(glb_, index, who + ".POSITION", GltfKind::Positions));
    WEFT_CHECK(check_room(positions.count(), 0));
    const GlbRange range{parts_.ranges.size(),
                         index,
                         place,
                         parts_.positions.size(),
                         static_cast<std::size_t>(positions.count()),
                         skinned ? std::optional(parts_.bindings.size()) : std::nullopt};
    for (std::uint64_t i = 0; i < positions.count(); ++i) parts_.positions.push_back(positions.position(i));
    if (skinned) WEFT_CHECK(add_bindings(accessors, who, positions.count()));
    parts_.ranges.push_back(range);
    ranges_[accessors] = range;
    return range;
  }

  Result<void> add_bindings(const std::array<std::uint64_t, 3>& accessors, const std::string& who,
                            std::uint64_t count) {
    WEFT_TRY(joints, GltfAccessor::find(glb_, accessors[1], who + ".JOINTS_0", GltfKind::Joints));
    WEFT_TRY(weights, GltfAccessor::find(glb_, accessors[2], who + ".WEIGHTS_0", GltfKind::Weights));
    if (joints.count() != count || weights.count() != count)
      return input_error("%s has %llu positions, %llu joints and %llu weights; they must be as many.",
                         who.c_str(), static_cast<unsigned long long>(count),
                         static_cast<unsigned long long>(joints.count()),
                         static_cast<unsigned long long>(weights.count()));
    for (std::uint64_t i = 0; i < count; ++i) {
      Binding binding;
      double sum = 0;
      for (std::uint32_t k = 0; k < 4; ++k) {
        const double weight = weights.value(i, k);
        if (!(weight >= 0 && weight < HUGE_VAL))
          return input_error(
              "%s.WEIGHTS_0: weight %u of vertex %llu is %g; it must be finite, and not negative.",
              who.c_str(), k, static_cast<unsigned long long>(i), weight);
        sum += weight;
        binding.joints[k] = static_cast<std::uint16_t>(joints.index(i, k));
        binding.weights[k] = static_cast<float>(weight);
      }
      if (!(sum > 0))
        return input_error("%s.WEIGHTS_0: the weights of vertex %llu are all 0.", who.c_str(),
                           static_cast<unsigned long long>(i));
      for (float& weight : binding.weights) weight = static_cast<float>(static_cast<double>(weight) / sum);
      parts_.bindings.push_back(binding);
    }
    return {};
  }

  Result<void> add_primitive(const Json& primitive, const std::string& path, std::size_t place) {
    WEFT_TRY(mode, whole_number(primitive, path, "mode", kFan, kTriangles));
    if (mode < kTriangles)
      return input_error("%s.mode is %llu, points or lines; triangles (4), strips (5) and fans (6) are read.",
                         path.c_str(), static_cast<unsigned long long>(mode));
    WEFT_TRY(vertices, add_vertices(primitive, path, place));
    std::optional<GltfAccessor> indices;
    if (primitive.find("indices") != nullptr) {
      WEFT_TRY(number, whole_number(primitive, path, "indices", kMostIndex));
      WEFT_TRY(found, GltfAccessor::find(glb_, number, path + ".indices", GltfKind::Indices));
      indices = found;
    }
    const std::uint64_t count = indices ? indices->count() : vertices.count;
    if (count < 3 || (mode == kTriangles && count % 3 != 0))
      return input_error("%s has %llu corners, which are no whole number of triangles.", path.c_str(),
                         static_cast<unsigned long long>(count));
    WEFT_CHECK(check_room(0, mode == kTriangles ? count / 3 : count - 2));
    for (std::uint64_t i = 0; indices && i < count; ++i)
      if (indices->index(i) >= vertices.count)
        return input_error("%s names vertex %u, but has %llu, from 0.", path.c_str(), indices->index(i),
                           static_cast<unsigned long long>(vertices.count));
    const auto corner = [&](std::uint64_t i) {
      return static_cast<std::uint32_t>(vertices.first + (indices ? indices->index(i) : i));
    };
    const std::size_t first = parts_.triangles.size();
    add_triangles(mode, count, corner);
    const std::size_t added = parts_.triangles.size() - first;
    if (!parts_.primitives.empty() && parts_.primitives.back().range == vertices.number)
      parts_.primitives.back().count += added;
    else
      parts_.primitives.push_back({vertices.number, first, added});
    return {};
  }

  // Strips run on through triangles that name a vertex twice; those are only a way to get elsewhere.
  template <class Corner>
  void add_triangles(std::uint64_t mode, std::uint64_t count, Corner corner) {
    const std::uint64_t step = mode == kTriangles ? 3 : 1;
    for (std::uint64_t i = 0; i + 2 < count; i += step) {
      const std::uint64_t odd = mode == kStrip ? i % 2 : 0;
      Triangle t{corner(mode == kFan ? 0 : i), corner(i + 1 + odd), corner(i + 2 - odd)};
      if (mode == kStrip && (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])) continue;
      parts_.triangles.push_back(t);
    }
  }

  const GlbChunks& glb_;
  std::size_t file_size_;
  std::uint64_t limit_;  // bytes of positions, bindings and triangles
  bool skins_;
  GlbParts parts_;
  std::map<std::array<std::uint64_t, 3>, GlbRange> ranges_;  // by accessors, of the present node
};

}  // namespace

std::string path_of_node(const SceneNode& node) {
  return path_of_index("nodes", static_cast<std::size_t>(node.number));
}

Result<GlbParts> read_glb_parts(const GlbChunks& glb, std::size_t file_size, bool skins) {
  WEFT_CHECK(check_version(glb.json));
  WEFT_CHECK(check_extensions(glb.json));
  return Assembly(glb, file_size, skins).run();
}

Result<void> check_coordinates(const Vec3d& place, const GlbRange& range, std::size_t vertex,
                               const SceneNode& node) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::abs(place[axis]) <= static_cast<double>(FLT_MAX)))
      return input_error(
          "Vertex %zu of accessors[%llu], where nodes[%llu] puts it, has the coordinate %g, "
          "which is not finite in single precision, where the largest is %.8e.",
          vertex, static_cast<unsigned long long>(range.accessor),
          static_cast<unsigned long long>(node.number), place[axis], static_cast<double>(FLT_MAX));
  return {};
}

}  // namespace weft::mesh
