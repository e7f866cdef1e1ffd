#pragma once

#include <doctest/doctest.h>

#include "gpu/device.hpp"

namespace weft {

/// The device of one test; any error that no call returned fails the test at its end.
class GpuFixture {
 public:
  GpuFixture() {
    auto made = gpu::Device::create();
    REQUIRE_MESSAGE(made, (made ? "" : made.error().message));
    device_ = std::move(*made);
  }
  ~GpuFixture() {
    const auto status = device_->status();
    CHECK_MESSAGE(status, (status ? "" : status.error().message));
  }
  gpu::Device& device() { return *device_; }

 private:
  std::unique_ptr<gpu::Device> device_;
};

}  // namespace weft
