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

void Readback::take(std::span<std::byte> target) {
  assert((ready() || failed()) && target.size() <= buffer_.bytes());
  if (ready()) backend::take_mapped(buffer_.id(), target);
  *state_ = backend::MapState::Idle;
}

std::vector<std::byte> Readback::take() {
  std::vector<std::byte> bytes(failed() ? 0 : buffer_.bytes());
  take(bytes);
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
