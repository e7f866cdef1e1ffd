#include "mesh/glb_animation.hpp"

#include <cassert>
#include <cstdio>

#include "base/json.hpp"
#include "mesh/glb_chunks.hpp"
#include "mesh/little_endian.hpp"

namespace weft::mesh {
namespace {

constexpr const char *kVertexData = "34962", *kIndexData = "34963";
constexpr const char *kVec3 = R"(,"componentType":5126,"type":"VEC3")",
                     *kVec2 = R"(,"componentType":5126,"type":"VEC2")",
                     *kScalar = R"(,"componentType":5126,"type":"SCALAR")",
                     *kIndex = R"(,"componentType":5125,"type":"SCALAR")";

/// `width` characters for each number at least, so that others can stand in their place.
std::string bounds_text(const Bounds& box, int width) {
  std::string text;
  for (const auto& [name, p] : {std::pair{R"(,"min":[)", box.low}, std::pair{R"(],"max":[)", box.high}})
    for (int axis = 0; axis < 3; ++axis) {
      char number[32];
      std::snprintf(number, sizeof number, "%*.9g", width, static_cast<double>(p[axis]));
      text += (axis == 0 ? std::string(name) : ",") + number;
    }
  return text + "]";
}

Bounds bounds_of(std::span<const Vec3f> points) {
  Bounds box{points[0], points[0]};
  for (const Vec3f& p : points) box = {min(box.low, p), max(box.high, p)};
  return box;
}

void append(std::vector<std::byte>& bytes, std::span<const Vec3f> points) {
  for (const Vec3f& p : points)
    for (int axis = 0; axis < 3; ++axis) append_little_endian(bytes, p[axis]);
}

}  // namespace

/// The arrays of the file, one after the other, and what stands where in them.
struct GlbAnimation::Layout {
  std::string accessors, views;
  std::size_t accessor_count = 0, view_count = 0;
  std::uint64_t bytes = 0;

  std::size_t add_view(std::uint64_t size, const char* target) {
    views += (view_count > 0 ? "," : "") + (R"({"buffer":0,"byteOffset":)" + std::to_string(bytes)) +
             R"(,"byteLength":)" + std::to_string(size) +
             (target != nullptr ? R"(,"target":)" + std::string(target) : "") + "}";
    bytes += size;
    return view_count++;
  }
  std::string add_accessor(std::size_t view, std::uint64_t offset, std::uint64_t count,
                           const std::string& members) {
    accessors += (accessor_count > 0 ? "," : "") + (R"({"bufferView":)" + std::to_string(view)) +
                 (offset > 0 ? R"(,"byteOffset":)" + std::to_string(offset) : "") + R"(,"count":)" +
                 std::to_string(count) + members + "}";
    return std::to_string(accessor_count++);
  }
};

GlbAnimation::GlbAnimation(const TriangleMesh& first, const VertexAttributes& attributes,
                           std::span<const MeshPart> parts, std::span<const float> times)
    : first_(first),
      attributes_(attributes),
      parts_(parts.begin(), parts.end()),
      times_(times.begin(), times.end()) {
  assert(check_mesh(first));
  if (parts_.empty())
    parts_.push_back({"",
                      static_cast<std::uint32_t>(first.positions.size()),
                      static_cast<std::uint32_t>(first.triangles.size()),
                      {}});
}

std::uint64_t GlbAnimation::least_size(std::uint64_t vertices, std::uint64_t triangles,
                                       std::uint64_t shapes) {
  return 2 * sizeof(Vec3f) * vertices * shapes + sizeof(Triangle) * triangles +
         sizeof(float) * shapes * (shapes - 1);
}

void GlbAnimation::add_first(Layout& layout, std::vector<std::string>& primitives) const {
  const std::size_t vertices = first_.positions.size();
  struct Attribute {
    const char *name, *members;
    std::size_t element, count;
  };
  for (const Attribute& one :
       {Attribute{"POSITION", kVec3, sizeof(Vec3f), vertices},
        Attribute{"NORMAL", kVec3, sizeof(Vec3f), attributes_.normals.size()},
        Attribute{"TEXCOORD_0", kVec2, 2 * sizeof(float), attributes_.texture.size()}}) {
    if (one.count == 0) continue;
    const std::size_t view = layout.add_view(one.element * vertices, kVertexData);
    std::size_t begin = 0;
    for (std::size_t p = 0; p < parts_.size(); begin += parts_[p++].vertices) {
      std::string members = one.members;
      if (one.name[0] == 'P')
        members += bounds_text(bounds_of(std::span(first_.positions).subspan(begin, parts_[p].vertices)), 0);
      primitives[p] += (one.name[0] == 'P' ? R"("attributes":{")" : R"(,")") + std::string(one.name) +
                       "\":" + layout.add_accessor(view, one.element * begin, parts_[p].vertices, members);
    }
  }
  const std::size_t view = layout.add_view(sizeof(Triangle) * first_.triangles.size(), kIndexData);
  std::size_t begin = 0;
  for (std::size_t p = 0; p < parts_.size(); begin += parts_[p++].triangles)
    primitives[p] +=
        R"(},"indices":)" +
        layout.add_accessor(view, sizeof(Triangle) * begin, std::uint64_t{3} * parts_[p].triangles, kIndex) +
        R"(,"material":)" + std::to_string(p);
}

void GlbAnimation::add_targets(Layout& layout, std::vector<std::string>& primitives) const {
  constexpr int kLongest = 16;  // "-1.17549435e-38" and one more
  for (std::size_t t = 0; t < targets(); ++t)
    for (const char* name : {"POSITION", "NORMAL"}) {
      const std::size_t view = layout.add_view(sizeof(Vec3f) * first_.positions.size(), kVertexData);
      std::size_t begin = 0;
      for (std::size_t p = 0; p < parts_.size(); begin += parts_[p++].vertices) {
        const bool places = name[0] == 'P';
        const std::size_t number = t * parts_.size() + p;
        std::string members = kVec3;
        if (places) members += bounds_text(number < bounds_.size() ? bounds_[number] : Bounds{}, kLongest);
        primitives[p] +=
            (places ? (t == 0 ? R"(,"targets":[{")" : R"(,{")") : R"(,")") + std::string(name) +
            "\":" + layout.add_accessor(view, sizeof(Vec3f) * begin, parts_[p].vertices, members) +
            (places ? "" : "}");
      }
    }
  if (targets() == 0) return;
  for (std::string& primitive : primitives) primitive += "]";
}

std::string GlbAnimation::add_times(Layout& layout) const {
  if (targets() == 0) return {};
  char range[96];
  std::snprintf(range, sizeof range, R"(,"min":[%.9g],"max":[%.9g])", static_cast<double>(times_.front()),
                static_cast<double>(times_.back()));
  const std::size_t view = layout.add_view(sizeof(float) * times_.size(), nullptr);
  return layout.add_accessor(view, 0, times_.size(), std::string(kScalar) + range);
}

/// One sampler moves the weights of all nodes.
std::string GlbAnimation::add_animation(Layout& layout, const std::string& input) const {
  if (targets() == 0) return {};
  const std::uint64_t weights = std::uint64_t{times_.size()} * targets();
  const std::string output =
      layout.add_accessor(layout.add_view(sizeof(float) * weights, nullptr), 0, weights, kScalar);
  std::string text = R"(,"animations":[{"name":"cloth","samplers":[{"input":)" + input + R"(,"output":)" +
                     output + R"(}],"channels":[)";
  for (std::size_t p = 0; p < parts_.size(); ++p)
    text += (p > 0 ? "," : "") + std::string(R"({"sampler":0,"target":{"node":)") + std::to_string(p) +
            R"(,"path":"weights"}})";
  return text + "]}]";
}

std::string GlbAnimation::document(std::uint64_t& binary_size) const {
  Layout layout;
  std::vector<std::string> primitives(parts_.size());
  add_first(layout, primitives);
  const std::string times = add_times(layout);
  add_targets(layout, primitives);
  const std::string animation = add_animation(layout, times);
  std::string roots, nodes, meshes, materials;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const std::string comma = p > 0 ? "," : "", number = std::to_string(p);
    const std::string name = parts_[p].name.empty() ? "" : R"(,"name":)" + json_text(parts_[p].name);
    roots += comma + number;
    nodes += comma + R"({"mesh":)" + number + name + "}";
    meshes += comma + R"({"primitives":[{)" + primitives[p] + "}]" + name + "}";
    materials += comma + R"({"doubleSided":true,"pbrMetallicRoughness":{"metallicFactor":0)";
    if (parts_[p].color) {
      char color[96];
      std::snprintf(color, sizeof color, R"(,"baseColorFactor":[%.6g,%.6g,%.6g,1])", parts_[p].color->x,
                    parts_[p].color->y, parts_[p].color->z);
      materials += color;
    }
    materials += "}" + name + "}";
  }
  binary_size = layout.bytes;
  return R"({"asset":{"version":"2.0","generator":"weft"},"scene":0,"scenes":[{"nodes":[)" + roots +
         R"(]}],"nodes":[)" + nodes + R"(],"meshes":[)" + meshes + R"(],"materials":[)" + materials + "]" +
         animation + R"(,"accessors":[)" + layout.accessors + R"(],"bufferViews":[)" + layout.views +
         R"(],"buffers":[{"byteLength":)" + std::to_string(layout.bytes) + "}]}";
}

std::uint64_t GlbAnimation::size() const {
  std::uint64_t binary = 0;
  const std::uint64_t json = document(binary).size();
  return kGlbHeaderSize + 2 * kGlbChunkHeaderSize + (json + 3) / 4 * 4 + binary;
}

std::vector<std::byte> GlbAnimation::begin() const {
  std::uint64_t binary = 0;
  std::string json = document(binary);
  return glb_before_binary(std::move(json), binary);
}

std::vector<std::byte> GlbAnimation::first() const {
  std::vector<std::byte> bytes;
  append(bytes, first_.positions);
  append(bytes, attributes_.normals);
  for (const auto& [u, v] : attributes_.texture) {
    append_little_endian(bytes, u);
    append_little_endian(bytes, 1 - v);  // glTF counts from the upper edge of a picture
  }
  std::uint32_t begin = 0;  // a part's vertices count from 0
  std::size_t triangle = 0;
  for (const MeshPart& part : parts_) {
    for (const std::size_t end = triangle + part.triangles; triangle < end; ++triangle)
      for (const std::uint32_t vertex : first_.triangles[triangle])
        append_little_endian(bytes, vertex - begin);
    begin += part.vertices;
  }
  if (targets() > 0)
    for (const float time : times_) append_little_endian(bytes, time);
  return bytes;
}

std::vector<std::byte> GlbAnimation::next(std::span<const Vec3f> positions, std::span<const Vec3f> normals) {
  assert(positions.size() == first_.positions.size() && normals.size() == attributes_.normals.size());
  std::vector<Vec3f> change(positions.size());
  std::vector<std::byte> bytes;
  bytes.reserve(2 * sizeof(Vec3f) * positions.size());
  for (std::size_t v = 0; v < change.size(); ++v) change[v] = positions[v] - first_.positions[v];
  std::size_t begin = 0;
  for (const MeshPart& part : parts_) {
    bounds_.push_back(bounds_of(std::span(change).subspan(begin, part.vertices)));
    begin += part.vertices;
  }
  append(bytes, change);
  for (std::size_t v = 0; v < change.size(); ++v) change[v] = normals[v] - attributes_.normals[v];
  append(bytes, change);
  return bytes;
}

std::vector<std::byte> GlbAnimation::weights(std::size_t shape) const {
  std::vector<std::byte> bytes;
  for (std::size_t t = 0; t < targets(); ++t) append_little_endian(bytes, t + 1 == shape ? 1.0F : 0.0F);
  return bytes;
}

}  // namespace weft::mesh
