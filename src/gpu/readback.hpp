#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "gpu/buffer.hpp"
#include "gpu/command_list.hpp"
#include "gpu/device.hpp"

namespace weft::gpu {

/// Bytes on their way from the GPU to the host, without the host waiting: record the copy, submit, start,
/// look again later.
class Readback {
 public:
  Readback() = default;
  static Result<Readback> create(Device& device, std::uint64_t bytes, const std::string& label);

  /// Where a command list copies to.
  BindingSource target() const { return buffer_.source(); }
  /// Asks for the bytes; call after the submit that fills them.
  void start();
  bool pending() const { return *state_ != backend::MapState::Idle; }
  /// True once the bytes are here; needs Device::poll now and then.
  bool ready() const { return *state_ == backend::MapState::Ready; }
  bool failed() const { return *state_ == backend::MapState::Failed; }
  /// Copies the bytes out, if it has not failed; the readback can then be used again. Only when ready or
  /// failed.
  void take(std::span<std::byte> target);
  std::vector<std::byte> take();  ///< empty where it failed

 private:
  RawBuffer buffer_;
  std::shared_ptr<backend::MapState> state_ = std::make_shared<backend::MapState>(backend::MapState::Idle);
  Device* device_ = nullptr;
};

/// A buffer's bytes, waited for: for snapshots, export and tests, never inside a frame.
/// Errors  DeviceLost, OutOfMemory.
Result<std::vector<std::byte>> download_bytes(Device& device, const BindingSource& source);

template <class T>
Result<std::vector<T>> download(Device& device, const Buffer<T>& buffer) {
  std::vector<T> values(buffer.size());
  if (values.empty()) return values;
  WEFT_TRY(bytes, download_bytes(device, buffer.range(0, buffer.size() * sizeof(T))));
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<std::byte*>(values.data()));
  return values;
}

}  // namespace weft::gpu
