#include "gpu/buffer.hpp"

namespace weft::gpu {

Result<RawBuffer> RawBuffer::create(Device& device, std::uint64_t bytes, std::uint32_t usage,
                                    const std::string& label) {
  const Limits& limits = device.limits();
  if (bytes > limits.max_buffer_size)
    return make_error(ErrorKind::Limit,
                      "Buffer %s needs %llu bytes, more than this adapter's maxBufferSize of %llu.",
                      label.c_str(), static_cast<unsigned long long>(bytes),
                      static_cast<unsigned long long>(limits.max_buffer_size));
  if ((usage & kStorage) != 0 && bytes > limits.max_storage_binding_size)
    return make_error(
        ErrorKind::Limit,
        "Buffer %s needs %llu bytes, more than this adapter's maxStorageBufferBindingSize of %llu.",
        label.c_str(), static_cast<unsigned long long>(bytes),
        static_cast<unsigned long long>(limits.max_storage_binding_size));
  WEFT_TRY(id, backend::create_buffer(device.context(), bytes, usage, label));
  RawBuffer buffer;
  buffer.object_ = Object(ObjectKind::Buffer, id);
  buffer.device_ = &device;
  buffer.bytes_ = bytes;
  buffer.label_ = label;
  device.count_allocation(static_cast<std::int64_t>(bytes));
  return buffer;
}

RawBuffer& RawBuffer::operator=(RawBuffer&& other) noexcept {
  if (this == &other) return *this;
  if (object_) device_->count_allocation(-static_cast<std::int64_t>(bytes_));
  object_ = std::move(other.object_);
  device_ = other.device_;
  bytes_ = other.bytes_;
  label_ = std::move(other.label_);
  return *this;
}

RawBuffer::~RawBuffer() {
  if (object_) device_->count_allocation(-static_cast<std::int64_t>(bytes_));
}

}  // namespace weft::gpu
