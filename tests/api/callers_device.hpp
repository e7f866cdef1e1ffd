// A program that uses the GPU itself, beside weft.
#pragma once

#include <doctest/doctest.h>
#include <webgpu.h>
#include <wgpu.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "weft/native.hpp"

namespace weft {

/// A device of the adapter that lies first, and what reached its callbacks.
class CallersDevice {
 public:
  explicit CallersDevice(const WGPULimits& limits = WGPU_LIMITS_INIT) {
    instance_ = wgpuCreateInstance(nullptr);
    WGPURequestAdapterCallbackInfo wanted = WGPU_REQUEST_ADAPTER_CALLBACK_INFO_INIT;
    wanted.mode = WGPUCallbackMode_AllowSpontaneous;
    wanted.callback = [](WGPURequestAdapterStatus, WGPUAdapter adapter, WGPUStringView, void* user, void*) {
      *static_cast<WGPUAdapter*>(user) = adapter;
    };
    wanted.userdata1 = &adapter_;
    wgpuInstanceRequestAdapter(instance_, nullptr, wanted);
    REQUIRE(adapter_ != nullptr);
    WGPUDeviceDescriptor descriptor = WGPU_DEVICE_DESCRIPTOR_INIT;
    descriptor.requiredLimits = &limits;
    descriptor.uncapturedErrorCallbackInfo.callback = [](WGPUDevice const*, WGPUErrorType, WGPUStringView,
                                                         void* user, void*) { ++*static_cast<int*>(user); };
    descriptor.uncapturedErrorCallbackInfo.userdata1 = &errors_;
    WGPURequestDeviceCallbackInfo callback = WGPU_REQUEST_DEVICE_CALLBACK_INFO_INIT;
    callback.mode = WGPUCallbackMode_AllowSpontaneous;
    callback.callback = [](WGPURequestDeviceStatus, WGPUDevice device, WGPUStringView, void* user, void*) {
      *static_cast<WGPUDevice*>(user) = device;
    };
    callback.userdata1 = &device_;
    wgpuAdapterRequestDevice(adapter_, &descriptor, callback);
    REQUIRE(device_ != nullptr);
  }
  ~CallersDevice() {
    wgpuDeviceRelease(device_);
    wgpuAdapterRelease(adapter_);
    wgpuInstanceRelease(instance_);
  }
  CallersDevice(const CallersDevice&) = delete;
  CallersDevice& operator=(const CallersDevice&) = delete;

  NativeDevice native() const { return {adapter_, device_}; }
  WGPUDevice device() const { return device_; }
  int errors() const { return errors_; }  // that no scope caught

 private:
  WGPUInstance instance_ = nullptr;
  WGPUAdapter adapter_ = nullptr;
  WGPUDevice device_ = nullptr;
  int errors_ = 0;
};

/// A texture of the caller's, which can be drawn into and read.
class CallersTexture {
 public:
  static WGPUTextureDescriptor drawable(WGPUTextureFormat format, std::uint32_t width, std::uint32_t height) {
    WGPUTextureDescriptor descriptor = WGPU_TEXTURE_DESCRIPTOR_INIT;
    descriptor.size = {width, height, 1};
    descriptor.format = format;
    descriptor.usage = WGPUTextureUsage_RenderAttachment | WGPUTextureUsage_CopySrc;
    return descriptor;
  }
  CallersTexture(WGPUDevice device, const WGPUTextureDescriptor& descriptor)
      : texture_(wgpuDeviceCreateTexture(device, &descriptor)) {}
  ~CallersTexture() { wgpuTextureRelease(texture_); }
  CallersTexture(const CallersTexture&) = delete;
  CallersTexture& operator=(const CallersTexture&) = delete;

  NativeTarget target() const { return {texture_}; }

 private:
  WGPUTexture texture_;
};

/// The first bytes of a buffer with usage MapRead, once all that was submitted is done.
inline std::vector<std::byte> take_bytes(WGPUDevice device, WGPUBuffer buffer, std::size_t bytes) {
  WGPUBufferMapCallbackInfo callback = WGPU_BUFFER_MAP_CALLBACK_INFO_INIT;
  callback.mode = WGPUCallbackMode_AllowSpontaneous;
  callback.callback = [](WGPUMapAsyncStatus, WGPUStringView, void*, void*) {};
  wgpuBufferMapAsync(buffer, WGPUMapMode_Read, 0, bytes, callback);
  wgpuDevicePoll(device, 1, nullptr);
  std::vector<std::byte> values(bytes);
  const void* mapped = wgpuBufferGetConstMappedRange(buffer, 0, bytes);
  REQUIRE(mapped != nullptr);
  std::memcpy(values.data(), mapped, bytes);
  return values;
}

/// Copies by `record`(encoder, buffer), a command of the caller's own, and takes what arrived.
template <class Record>
std::vector<std::byte> copied(WGPUDevice device, std::size_t bytes, const Record& record) {
  WGPUBufferDescriptor descriptor = WGPU_BUFFER_DESCRIPTOR_INIT;
  descriptor.size = bytes;
  descriptor.usage = WGPUBufferUsage_CopyDst | WGPUBufferUsage_MapRead;
  WGPUBuffer buffer = wgpuDeviceCreateBuffer(device, &descriptor);
  WGPUCommandEncoder encoder = wgpuDeviceCreateCommandEncoder(device, nullptr);
  record(encoder, buffer);
  WGPUCommandBuffer commands = wgpuCommandEncoderFinish(encoder, nullptr);
  WGPUQueue queue = wgpuDeviceGetQueue(device);
  wgpuQueueSubmit(queue, 1, &commands);
  std::vector<std::byte> values = take_bytes(device, buffer, bytes);
  wgpuQueueRelease(queue);
  wgpuCommandBufferRelease(commands);
  wgpuCommandEncoderRelease(encoder);
  wgpuBufferRelease(buffer);
  return values;
}

inline std::vector<std::byte> bytes_of(WGPUDevice device, const NativeBuffer& source) {
  const std::size_t bytes = source.count * source.stride;
  return copied(device, bytes, [&](WGPUCommandEncoder encoder, WGPUBuffer target) {
    wgpuCommandEncoderCopyBufferToBuffer(encoder, source.buffer, source.offset, target, 0, bytes);
  });
}

/// The picture in a texture, red first.
inline std::vector<std::uint8_t> pixels_of(WGPUDevice device, const NativeTarget& source) {
  const std::uint32_t width = wgpuTextureGetWidth(source.texture),
                      height = wgpuTextureGetHeight(source.texture);
  const std::uint32_t row = (4 * width + 255) / 256 * 256;  // WebGPU's alignment of rows
  const std::vector<std::byte> rows =
      copied(device, std::size_t{row} * height, [&](WGPUCommandEncoder encoder, WGPUBuffer target) {
        WGPUTexelCopyTextureInfo from = WGPU_TEXEL_COPY_TEXTURE_INFO_INIT;
        from.texture = source.texture;
        WGPUTexelCopyBufferInfo to = WGPU_TEXEL_COPY_BUFFER_INFO_INIT;
        to.buffer = target;
        to.layout.bytesPerRow = row;
        to.layout.rowsPerImage = height;
        const WGPUExtent3D size = {width, height, 1};
        wgpuCommandEncoderCopyTextureToBuffer(encoder, &from, &to, &size);
      });
  const WGPUTextureFormat format = wgpuTextureGetFormat(source.texture);
  const bool blue_first =
      format == WGPUTextureFormat_BGRA8Unorm || format == WGPUTextureFormat_BGRA8UnormSrgb;
  std::vector<std::uint8_t> pixels;
  pixels.reserve(std::size_t{4} * width * height);
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      for (const std::size_t channel : {blue_first ? 2U : 0U, 1U, blue_first ? 0U : 2U, 3U})
        pixels.push_back(
            static_cast<std::uint8_t>(rows[std::size_t{y} * row + 4 * std::size_t{x} + channel]));
  return pixels;
}

}  // namespace weft
