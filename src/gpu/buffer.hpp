#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "base/result.hpp"
#include "gpu/device.hpp"
#include "gpu/object.hpp"

namespace weft::gpu {

/// Bytes on the GPU; Buffer<T> gives them a type.
class RawBuffer {
 public:
  RawBuffer() = default;
  RawBuffer(RawBuffer&&) noexcept = default;
  RawBuffer& operator=(RawBuffer&& other) noexcept;
  ~RawBuffer();

  /// Errors  Limit: larger than the device's limit, which is named with both numbers. OutOfMemory,
  /// DeviceLost.
  static Result<RawBuffer> create(Device& device, std::uint64_t bytes, std::uint32_t usage,
                                  const std::string& label);

  Id id() const { return object_.id(); }
  std::uint64_t bytes() const { return bytes_; }
  const std::string& label() const { return label_; }
  BindingSource source() const { return {object_.id(), ObjectKind::Buffer, 0, bytes_}; }
  BindingSource range(std::uint64_t offset, std::uint64_t bytes) const {
    return {object_.id(), ObjectKind::Buffer, offset, bytes};
  }

 private:
  Object object_;
  Device* device_ = nullptr;
  std::uint64_t bytes_ = 0;
  std::string label_;
};

inline constexpr std::uint32_t kStorageDefault = kStorage | kCopySource | kCopyTarget;
/// The same for what a program may draw from: positions and what goes with them.
inline constexpr std::uint32_t kVertexStorage = kStorageDefault | kVertex;

/// `count` elements of T on the GPU. T is what WGSL sees: 4, 8 or 16 bytes aligned plain data.
template <class T>
class Buffer : public RawBuffer {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % 4 == 0);

 public:
  Buffer() = default;

  /// A buffer of zeros. Room for at least one element is taken: WebGPU has no empty binding.
  static Result<Buffer> create(Device& device, std::size_t count, const std::string& label,
                               std::uint32_t usage = kStorageDefault) {
    WEFT_TRY(raw, RawBuffer::create(device, (count == 0 ? 1 : count) * sizeof(T), usage, label));
    Buffer buffer(std::move(raw));
    buffer.count_ = count;
    return buffer;
  }
  /// A buffer that holds `values`.
  static Result<Buffer> create_from(Device& device, std::span<const T> values, const std::string& label,
                                    std::uint32_t usage = kStorageDefault) {
    WEFT_TRY(buffer, create(device, values.size(), label, usage));
    buffer.write(device, values);
    return buffer;
  }

  /// Replaces elements from `first` on, before anything that is submitted later.
  void write(Device& device, std::span<const T> values, std::size_t first = 0) const {
    if (!values.empty()) device.write(range(first * sizeof(T), values.size_bytes()), std::as_bytes(values));
  }

  std::size_t size() const { return count_; }

 private:
  explicit Buffer(RawBuffer raw) : RawBuffer(std::move(raw)) {}

  std::size_t count_ = 0;
};

/// A uniform block that holds `value`.
template <class T>
Result<Buffer<T>> create_uniform(Device& device, const T& value, const std::string& label) {
  return Buffer<T>::create_from(device, std::span(&value, 1), label, kUniform | kCopyTarget);
}

}  // namespace weft::gpu
