#pragma once

#include <doctest/doctest.h>

#include <memory>

#include "at_end.hpp"
#include "gpu/device.hpp"

namespace weft {

/// Asks for a device of the test's own, one that it may change.
struct OwnDevice {};

/// The device of a test; any error that no call returned fails the test at its end. All tests of a program share one,
/// so that what they compile is compiled once, until one of them leaves an error.
class GpuFixture {
 public:
  GpuFixture() : device_(of_program()) {}
  explicit GpuFixture(OwnDevice) : device_(create()) {}
  ~GpuFixture() {
    const auto status = device_->status();
    CHECK_MESSAGE(status, (status ? "" : status.error().message));
    if (!status && of_program() == device_) of_program().reset();
  }
  GpuFixture(const GpuFixture&) = delete;
  gpu::Device& device() { return *device_; }

 private:
  static std::shared_ptr<gpu::Device>& of_program() {
    static std::shared_ptr<gpu::Device> device;
    if (device == nullptr) {
      device = create();
      at_end([] { device.reset(); });
    }
    return device;
  }
  static std::shared_ptr<gpu::Device> create() {
    auto made = gpu::Device::create();
    REQUIRE_MESSAGE(made, (made ? "" : made.error().message));
    return std::move(*made);
  }

  std::shared_ptr<gpu::Device> device_;
};

}  // namespace weft
