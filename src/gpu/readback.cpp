#include "gpu/readback.hpp"

#include <cassert>

namespace weft::gpu {

Result<Readback> Readback::create(Device& device, std::uint64_t bytes, const std::string& label) {
  WEFT_TRY(buffer, RawBuffer::create(device, bytes, kMapRead | kCopyTarget, label));
  Readback readback;
  readback.buffer_ = std::move(buffer);
  readback.device_ = &device;
  return readback;
}

void Readback::start() {
  assert(!pending());
  *state_ = backend::MapState::Pending;
  backend::map_read(device_->context(), buffer_.id(), buffer_.bytes(), state_);
}

std::vector<std::byte> Readback::take() {
  assert(ready() || failed());
  std::vector<std::byte> bytes;
  if (ready()) {
    const auto range = backend::mapped_range(buffer_.id(), buffer_.bytes());
    bytes.assign(range.begin(), range.end());
    backend::unmap(buffer_.id());
  }
  *state_ = backend::MapState::Idle;
  return bytes;
}

Result<std::vector<std::byte>> download_bytes(Device& device, const BindingSource& source) {
  WEFT_TRY(readback, Readback::create(device, source.size, "download"));
  CommandList list;
  list.copy(source, readback.target());
  WEFT_CHECK(device.submit(list));
  readback.start();
  WEFT_CHECK(device.wait());
  if (!readback.ready())
    return make_error(ErrorKind::DeviceLost, "A download of %llu bytes did not arrive.",
                      static_cast<unsigned long long>(source.size));
  return readback.take();
}

}  // namespace weft::gpu
