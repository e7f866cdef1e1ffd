#include "mesh/glb.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "mesh/glb_chunks.hpp"
#include "mesh/gltf_accessor.hpp"
#include "mesh/gltf_nodes.hpp"
#include "mesh/gltf_values.hpp"
#include "mesh/gzip.hpp"
#include "mesh/merge.hpp"
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

/// Builds the mesh, primitive after primitive, within a bound on its size.
class Assembly {
 public:
  Assembly(const GlbChunks& glb, std::size_t file_size)
      : glb_(glb),
        file_size_(file_size),
        limit_(std::min<std::uint64_t>(kMaxMeshBytes, kMaxGlbGrowth * file_size)) {}

  Result<void> add(const PlacedMesh& placed) {
    const std::string node = path_of_index("nodes", static_cast<std::size_t>(placed.node));
    WEFT_TRY(mesh, entry(glb_.json, "meshes", placed.mesh, node + ".mesh"));
    const std::string path = path_of_index("meshes", static_cast<std::size_t>(placed.mesh));
    WEFT_TRY(primitives, entries(*mesh, path, "primitives"));
    vertices_.clear();
    for (std::size_t i = 0; i < primitives->size(); ++i)
      WEFT_CHECK(add_primitive((*primitives)[i], path_of_index(path + ".primitives", i), placed));
    return {};
  }
  TriangleMesh& mesh() { return mesh_; }

 private:
  /// Vertices of one accessor, placed by the present node.
  struct Placed {
    std::uint64_t first = 0, count = 0;
  };

  Result<void> check_room(std::uint64_t vertices, std::uint64_t triangles) {
    const std::uint64_t bytes = sizeof(Vec3f) * (mesh_.positions.size() + vertices) +
                                sizeof(Triangle) * (mesh_.triangles.size() + triangles);
    if (bytes <= limit_) return {};
    return input_error(
        "The scene repeats its meshes until they take over %llu bytes, the limit for a file of %zu.",
        static_cast<unsigned long long>(limit_), file_size_);
  }

  // Primitives of a mesh often share their vertices and differ in their indices.
  Result<Placed> place_vertices(const Json& primitive, const std::string& path, const PlacedMesh& placed) {
    const Json* attributes = primitive.find("attributes");
    if (attributes == nullptr) return input_error("%s.attributes is missing.", path.c_str());
    const std::string who = path + ".attributes";
    WEFT_TRY(index, whole_number(*attributes, who, "POSITION", kMostIndex));
    if (const auto known = vertices_.find(index); known != vertices_.end()) return known->second;
    WEFT_TRY(accessor, GltfAccessor::find(glb_, index, who + ".POSITION", GltfKind::Positions));
    WEFT_CHECK(check_room(accessor.count(), 0));
    const Placed result{mesh_.positions.size(), accessor.count()};
    const bool moved = !(placed.placement == Affine{});  // else the bits stay
    for (std::uint64_t i = 0; i < accessor.count(); ++i) {
      const Vec3f position = accessor.position(i);
      const Vec3d there = moved ? placed.placement.point(position.to<double>()) : position.to<double>();
      for (int axis = 0; axis < 3; ++axis)
        if (!(std::abs(there[axis]) <= static_cast<double>(FLT_MAX)))
          return input_error(
              "Vertex %llu of accessors[%llu], where nodes[%llu] puts it, has the coordinate %g, "
              "which is not finite in single precision, where the largest is %.8e.",
              static_cast<unsigned long long>(i), static_cast<unsigned long long>(index),
              static_cast<unsigned long long>(placed.node), there[axis], static_cast<double>(FLT_MAX));
      mesh_.positions.push_back(there.to<float>());
    }
    vertices_[index] = result;
    return result;
  }

  Result<void> add_primitive(const Json& primitive, const std::string& path, const PlacedMesh& placed) {
    WEFT_TRY(mode, whole_number(primitive, path, "mode", kFan, kTriangles));
    if (mode < kTriangles)
      return input_error("%s.mode is %llu, points or lines; triangles (4), strips (5) and fans (6) are read.",
                         path.c_str(), static_cast<unsigned long long>(mode));
    WEFT_TRY(vertices, place_vertices(primitive, path, placed));
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
    add_triangles(mode, count, corner, placed.placement.determinant() < 0.0);
    return {};
  }

  // A placement that mirrors turns the triangles, so that their outside stays outside. Strips run on through
  // triangles that name a vertex twice; those are only a way to get elsewhere.
  template <class Corner>
  void add_triangles(std::uint64_t mode, std::uint64_t count, Corner corner, bool mirrored) {
    const std::uint64_t step = mode == kTriangles ? 3 : 1;
    for (std::uint64_t i = 0; i + 2 < count; i += step) {
      const std::uint64_t odd = mode == kStrip ? i % 2 : 0;
      Triangle t{corner(mode == kFan ? 0 : i), corner(i + 1 + odd), corner(i + 2 - odd)};
      if (mode == kStrip && (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])) continue;
      if (mirrored) std::swap(t[1], t[2]);
      mesh_.triangles.push_back(t);
    }
  }

  const GlbChunks& glb_;
  std::size_t file_size_;
  std::uint64_t limit_;  // bytes of positions and triangles
  TriangleMesh mesh_;
  std::map<std::uint64_t, Placed> vertices_;  // by accessor, of the present node
};

}  // namespace

Result<TriangleMesh> read_glb(std::span<const std::byte> bytes) {
  WEFT_TRY(glb, split_glb(bytes));
  WEFT_CHECK(check_version(glb.json));
  WEFT_CHECK(check_extensions(glb.json));
  WEFT_TRY(placed, placed_meshes(glb.json));
  Assembly assembly(glb, bytes.size());
  for (const PlacedMesh& mesh : placed) WEFT_CHECK(assembly.add(mesh));
  TriangleMesh result = std::move(assembly.mesh());
  WEFT_CHECK(check_mesh(result));
  merge_vertices(result);
  return result;
}

}  // namespace weft::mesh
