#include "mesh/gltf_accessor.hpp"

#include <cstring>

#include "mesh/gltf_values.hpp"

namespace weft::mesh {
namespace {

constexpr std::uint64_t kMostElements = 0xFFFFFFFF;  // more than the 4 GiB of a file can hold
constexpr std::uint64_t kUint8 = 5121, kUint16 = 5123, kUint32 = 5125, kFloat = 5126;  // componentType
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

Result<unsigned> component_size(const Json& accessor, const std::string& path, GltfKind kind) {
  WEFT_TRY(type, whole_number(accessor, path, "componentType", kMostElements));
  if (kind == GltfKind::Positions && type == kFloat) return 4U;
  if (kind == GltfKind::Indices && type == kUint8) return 1U;
  if (kind == GltfKind::Indices && type == kUint16) return 2U;
  if (kind == GltfKind::Indices && type == kUint32) return 4U;
  return input_error("%s.componentType is %llu; %s.", path.c_str(), static_cast<unsigned long long>(type),
                     kind == GltfKind::Positions
                         ? "positions are read from floats (5126)"
                         : "indices are read from bytes (5121), shorts (5123) and integers (5125), unsigned");
}

}  // namespace

Result<GltfAccessor> GltfAccessor::find(const GlbChunks& glb, std::uint64_t index, const std::string& who,
                                        GltfKind kind) {
  WEFT_TRY(accessor, entry(glb.json, "accessors", index, who));
  const std::string path = path_of_index("accessors", static_cast<std::size_t>(index));
  if (accessor->find("sparse") != nullptr)
    return input_error("%s.sparse: sparse accessors are not read.", path.c_str());
  WEFT_CHECK(expect_type(*accessor, path, kind == GltfKind::Positions ? "VEC3" : "SCALAR"));
  WEFT_TRY(component, component_size(*accessor, path, kind));
  const std::uint64_t size = kind == GltfKind::Positions ? 3 * component : component;  // bytes of an element
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
  return GltfAccessor(view.bytes.subspan(static_cast<std::size_t>(offset)), count, stride, component);
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

std::uint32_t GltfAccessor::index(std::uint64_t i) const { return load(i * stride_); }

}  // namespace weft::mesh
