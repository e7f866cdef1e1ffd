#include "gpu/device.hpp"

#include <algorithm>
#include <cassert>

namespace weft::gpu {

Device::Device(backend::Opened opened)
    : context_(std::move(opened.context)),
      adapter_(std::move(opened.adapter)),
      limits_(opened.limits),
      timestamps_(opened.timestamps) {}

Result<std::unique_ptr<Device>> Device::create(const DeviceOptions& options) {
  WEFT_TRY(opened, backend::open(options));
  return std::unique_ptr<Device>(new Device(std::move(opened)));
}

void Device::lower_limits(const Limits& limits) {
  limits_.max_buffer_size = std::min(limits_.max_buffer_size, limits.max_buffer_size);
  limits_.max_storage_binding_size =
      std::min(limits_.max_storage_binding_size, limits.max_storage_binding_size);
}

Result<void> Device::submit(const CommandList& list) {
  const CommandList* const lists[] = {&list};
  return submit(lists);
}

Result<void> Device::wait() {
  backend::wait(*context_);
  return backend::status(*context_);
}

void Device::write(const BindingSource& target, std::span<const std::byte> bytes) {
  assert(bytes.size() <= target.size);
  backend::write_buffer(*context_, target.id, target.offset, bytes);
}

}  // namespace weft::gpu
