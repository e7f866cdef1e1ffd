#include "mesh/gltf_accessor.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "mesh/gltf_values.hpp"

namespace weft::mesh {
namespace {

constexpr std::uint64_t kMostElements = 0xFFFFFFFF;  // more than the 4 GiB of a file can hold
// componentType
constexpr std::uint64_t kInt8 = 5120, kUint8 = 5121, kInt16 = 5122, kUint16 = 5123, kUint32 = 5125,
                        kFloat = 5126;
constexpr std::uint64_t kMaxStride = 252;

/// The bytes of a buffer view, with its stride, or 0 where it has none.
struct View {
  std::span<const std::byte> bytes;
  std::uint64_t stride = 0;
};

// The buffer of a GLB file is its binary chunk, which may be longer by some bytes of padding.
Result<std::span<const std::byte>> find_buffer(const GlbChunks& glb, std::uint64_t index,
                                               const std::string& who) {
  WEFT_TRY(buffer, entry(glb.json, "buffers", index, who));
  const std::string path = path_of_index("buffers", static_cast<std::size_t>(index));
  if (buffer->find("uri") != nullptr)
    return input_error("%s.uri names data outside of the file, which are not read.", path.c_str());
  if (index != 0) return input_error("%s has no data: only the first buffer is in a GLB file.", path.c_str());
  WEFT_TRY(length, whole_number(*buffer, path, "byteLength", glb.binary.size()));
  return glb.binary.first(static_cast<std::size_t>(length));
}

Result<View> find_view(const GlbChunks& glb, std::uint64_t index, const std::string& who) {
  WEFT_TRY(view, entry(glb.json, "bufferViews", index, who));
  const std::string path = path_of_index("bufferViews", static_cast<std::size_t>(index));
  WEFT_TRY(number, whole_number(*view, path, "buffer", kMostElements));
  WEFT_TRY(buffer, find_buffer(glb, number, path + ".buffer"));
  WEFT_TRY(offset, whole_number(*view, path, "byteOffset", buffer.size(), 0));
  WEFT_TRY(length, whole_number(*view, path, "byteLength", buffer.size() - offset));
  WEFT_TRY(stride, whole_number(*view, path, "byteStride", kMaxStride, 0));
  return View{buffer.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length)), stride};
}

Result<void> expect_type(const Json& accessor, const std::string& path, const char* expected) {
  const Json* type = accessor.find("type");
  if (type != nullptr && type->kind == Json::Kind::Text && type->text == expected) return {};
  return input_error("%s.type is %s; it must be \"%s\".", path.c_str(),
                     type != nullptr ? describe(*type).c_str() : "missing", expected);
}

/// What the specification has for a kind.
struct Shape {
  const char* type;
  unsigned components;
  std::array<std::uint64_t, 5> component_types;  // 0: none
  const char* words;                             // of the component types
};
Shape shape_of(GltfKind kind) {
  switch (kind) {
    case GltfKind::Positions:
      return {"VEC3", 3, {kFloat}, "positions are read from floats (5126)"};
    case GltfKind::Indices:
      return {"SCALAR",
              1,
              {kUint8, kUint16, kUint32},
              "indices are read from bytes (5121), shorts (5123) and integers (5125), unsigned"};
    case GltfKind::Joints:
      return {"VEC4", 4, {kUint8, kUint16}, "joints are read from bytes (5121) and shorts (5123), unsigned"};
    case GltfKind::Weights:
      return {"VEC4",
              4,
              {kFloat, kUint8, kUint16},
              "weights are read from floats (5126), and from bytes (5121) and shorts (5123), unsigned"};
    case GltfKind::Matrices:
      return {"MAT4", 16, {kFloat}, "matrices are read from floats (5126)"};
    case GltfKind::Times:
      return {"SCALAR", 1, {kFloat}, "times are read from floats (5126)"};
    case GltfKind::Vectors:
      return {"VEC3", 3, {kFloat}, "translations and scales are read from floats (5126)"};
    case GltfKind::Rotations:
      break;
  }
  return {"VEC4",
          4,
          {kFloat, kInt8, kUint8, kInt16, kUint16},
          "rotations are read from floats (5126), bytes (5120, 5121) and shorts (5122, 5123)"};
}

unsigned size_of(std::uint64_t component_type) {
  if (component_type == kInt8 || component_type == kUint8) return 1;
  return component_type == kInt16 || component_type == kUint16 ? 2 : 4;
}

Result<std::uint64_t> component_type_of(const Json& accessor, const std::string& path, const Shape& shape) {
  WEFT_TRY(type, whole_number(accessor, path, "componentType", kMostElements));
  if (std::find(shape.component_types.begin(), shape.component_types.end(), type) !=
      shape.component_types.end())
    return type;
  return input_error("%s.componentType is %llu; %s.", path.c_str(), static_cast<unsigned long long>(type),
                     shape.words);
}

}  // namespace

Result<GltfAccessor> GltfAccessor::find(const GlbChunks& glb, std::uint64_t index, const std::string& who,
                                        GltfKind kind) {
  WEFT_TRY(accessor, entry(glb.json, "accessors", index, who));
  const std::string path = path_of_index("accessors", static_cast<std::size_t>(index));
  if (accessor->find("sparse") != nullptr)
    return input_error("%s.sparse: sparse accessors are not read.", path.c_str());
  const Shape shape = shape_of(kind);
  WEFT_CHECK(expect_type(*accessor, path, shape.type));
  WEFT_TRY(type, component_type_of(*accessor, path, shape));
  const std::uint64_t size = std::uint64_t{shape.components} * size_of(type);  // bytes of an element
  WEFT_TRY(number, whole_number(*accessor, path, "bufferView", kMostElements));
  WEFT_TRY(view, find_view(glb, number, path + ".bufferView"));
  WEFT_TRY(offset, whole_number(*accessor, path, "byteOffset", view.bytes.size(), 0));
  const std::uint64_t stride = view.stride == 0 ? size : view.stride;
  if (stride < size)
    return input_error("bufferViews[%llu].byteStride is %llu, less than the %llu bytes of an element of %s.",
                       static_cast<unsigned long long>(number), static_cast<unsigned long long>(stride),
                       static_cast<unsigned long long>(size), path.c_str());
  const std::uint64_t room = view.bytes.size() - offset;
  WEFT_TRY(count, whole_number(*accessor, path, "count", room < size ? 0 : 1 + (room - size) / stride));
  return GltfAccessor(view.bytes.subspan(static_cast<std::size_t>(offset)), count, stride, type,
                      size_of(type));
}

// Little-endian, and aligned to nothing: a wrong offset is no reason to fail.
std::uint32_t GltfAccessor::load(std::uint64_t at) const {
  std::uint32_t value = 0;
  for (unsigned i = 0; i < size_; ++i)
    value |= std::to_integer<std::uint32_t>(bytes_[static_cast<std::size_t>(at) + i]) << (8 * i);
  return value;
}

Vec3f GltfAccessor::position(std::uint64_t i) const {
  Vec3f result;
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint32_t bits = load(i * stride_ + static_cast<std::uint64_t>(4 * axis));
    std::memcpy(&result[axis], &bits, sizeof bits);
  }
  return result;
}

std::uint32_t GltfAccessor::index(std::uint64_t i, std::uint32_t component) const {
  return load(i * stride_ + std::uint64_t{component} * size_);
}

double GltfAccessor::value(std::uint64_t i, std::uint32_t component) const {
  const std::uint32_t bits = index(i, component);
  switch (component_type_) {
    case kFloat: {
      float value = 0;
      std::memcpy(&value, &bits, sizeof value);
      return static_cast<double>(value);
    }
    case kInt8:
      return std::max(static_cast<double>(static_cast<std::int8_t>(bits)) / 127, -1.0);
    case kInt16:
      return std::max(static_cast<double>(static_cast<std::int16_t>(bits)) / 32767, -1.0);
    case kUint8:
      return bits / 255.0;
    case kUint16:
      return bits / 65535.0;
    default:
      return bits;
  }
}

}  // namespace weft::mesh
