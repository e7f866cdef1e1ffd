// own_device SCENE FRAMES PICTURE.png: a program that has a GPU device of its own, as a game or a window has. It gives
// the device to weft, lets it draw into a texture of the program's, and reads weft's buffer of positions by a copy of
// its own. Prints the hash of the last state and the largest distance [m] between the copy and what weft reads back.
#include <webgpu.h>
#include <wgpu.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <vector>
#include <weft/native.hpp>
#include <weft/weft.hpp>

namespace {

constexpr std::uint32_t kWidth = 1280, kHeight = 720;  // rows of 5120 bytes, a multiple of WebGPU's 256

weft::Error failure(const char* what) { return {weft::ErrorKind::Failure, what}; }

/// The program's instance, adapter, device and queue. wgpu-native calls back within the request.
struct Gpu {
  WGPUInstance instance = wgpuCreateInstance(nullptr);
  WGPUAdapter adapter = nullptr;
  WGPUDevice device = nullptr;
  WGPUQueue queue = nullptr;

  Gpu() {
    WGPURequestAdapterCallbackInfo on_adapter = WGPU_REQUEST_ADAPTER_CALLBACK_INFO_INIT;
    on_adapter.mode = WGPUCallbackMode_AllowSpontaneous;
    on_adapter.callback = [](WGPURequestAdapterStatus, WGPUAdapter found, WGPUStringView, void* user, void*) {
      *static_cast<WGPUAdapter*>(user) = found;
    };
    on_adapter.userdata1 = &adapter;
    wgpuInstanceRequestAdapter(instance, nullptr, on_adapter);
    if (adapter == nullptr) return;

    WGPULimits limits = WGPU_LIMITS_INIT;  // all that the adapter has: large cloths need large buffers
    wgpuAdapterGetLimits(adapter, &limits);
    WGPUDeviceDescriptor wanted = WGPU_DEVICE_DESCRIPTOR_INIT;
    wanted.requiredLimits = &limits;
    WGPURequestDeviceCallbackInfo on_device = WGPU_REQUEST_DEVICE_CALLBACK_INFO_INIT;
    on_device.mode = WGPUCallbackMode_AllowSpontaneous;
    on_device.callback = [](WGPURequestDeviceStatus, WGPUDevice made, WGPUStringView, void* user, void*) {
      *static_cast<WGPUDevice*>(user) = made;
    };
    on_device.userdata1 = &device;
    wgpuAdapterRequestDevice(adapter, &wanted, on_device);
    if (device != nullptr) queue = wgpuDeviceGetQueue(device);
  }
  ~Gpu() {
    if (queue != nullptr) wgpuQueueRelease(queue);
    if (device != nullptr) wgpuDeviceRelease(device);
    if (adapter != nullptr) wgpuAdapterRelease(adapter);
    wgpuInstanceRelease(instance);
  }
  Gpu(const Gpu&) = delete;
  Gpu& operator=(const Gpu&) = delete;
};

/// Bytes that `record` copies into a buffer of the program's, waited for.
std::vector<std::uint8_t> copy_back(const Gpu& gpu, std::uint64_t bytes,
                                    const std::function<void(WGPUCommandEncoder, WGPUBuffer)>& record) {
  WGPUBufferDescriptor descriptor = WGPU_BUFFER_DESCRIPTOR_INIT;
  descriptor.size = bytes;
  descriptor.usage = WGPUBufferUsage_CopyDst | WGPUBufferUsage_MapRead;
  WGPUBuffer buffer = wgpuDeviceCreateBuffer(gpu.device, &descriptor);
  WGPUCommandEncoder encoder = wgpuDeviceCreateCommandEncoder(gpu.device, nullptr);
  record(encoder, buffer);
  WGPUCommandBuffer commands = wgpuCommandEncoderFinish(encoder, nullptr);
  wgpuQueueSubmit(gpu.queue, 1, &commands);  // after all that weft has submitted

  WGPUBufferMapCallbackInfo on_mapped = WGPU_BUFFER_MAP_CALLBACK_INFO_INIT;
  on_mapped.mode = WGPUCallbackMode_AllowSpontaneous;
  on_mapped.callback = [](WGPUMapAsyncStatus, WGPUStringView, void*, void*) {};
  wgpuBufferMapAsync(buffer, WGPUMapMode_Read, 0, bytes, on_mapped);
  wgpuDevicePoll(gpu.device, 1, nullptr);
  std::vector<std::uint8_t> copied;
  if (const auto* mapped = static_cast<const std::uint8_t*>(wgpuBufferGetConstMappedRange(buffer, 0, bytes)))
    copied.assign(mapped, mapped + bytes);
  wgpuCommandBufferRelease(commands);
  wgpuCommandEncoderRelease(encoder);
  wgpuBufferRelease(buffer);
  return copied;
}

weft::Result<weft::Image> draw(const Gpu& gpu, weft::World& world) {
  WGPUTextureDescriptor descriptor = WGPU_TEXTURE_DESCRIPTOR_INIT;
  descriptor.size = {kWidth, kHeight, 1};
  descriptor.format = WGPUTextureFormat_RGBA8Unorm;
  descriptor.usage = WGPUTextureUsage_RenderAttachment | WGPUTextureUsage_CopySrc;
  WGPUTexture texture = wgpuDeviceCreateTexture(gpu.device, &descriptor);
  const weft::Result<void> drawn = world.draw_into({texture});
  weft::Image image{kWidth, kHeight, {}};
  if (drawn)
    image.rgba = copy_back(gpu, 4 * kWidth * kHeight, [&](WGPUCommandEncoder encoder, WGPUBuffer buffer) {
      WGPUTexelCopyTextureInfo from = WGPU_TEXEL_COPY_TEXTURE_INFO_INIT;
      from.texture = texture;
      WGPUTexelCopyBufferInfo to = WGPU_TEXEL_COPY_BUFFER_INFO_INIT;
      to.buffer = buffer;
      to.layout.bytesPerRow = 4 * kWidth;
      to.layout.rowsPerImage = kHeight;
      wgpuCommandEncoderCopyTextureToBuffer(encoder, &from, &to, &descriptor.size);
    });
  wgpuTextureRelease(texture);
  if (!drawn) return drawn.error();
  if (image.rgba.empty()) return failure("The picture cannot be read back.");
  return image;
}

/// The largest distance between the program's own copy of the positions and weft's [m].
weft::Result<double> copy_error(const Gpu& gpu, weft::World& world) {
  const weft::NativeBuffer positions = world.position().native();
  const std::uint64_t bytes = positions.count * positions.stride;
  const auto copied = copy_back(gpu, bytes, [&](WGPUCommandEncoder encoder, WGPUBuffer buffer) {
    wgpuCommandEncoderCopyBufferToBuffer(encoder, positions.buffer, positions.offset, buffer, 0, bytes);
  });
  if (copied.empty()) return failure("The positions cannot be read back.");
  std::vector<weft::Vec3f> read(positions.count);
  if (auto done = world.position().read(read); !done) return done.error();
  double largest = 0;
  for (std::size_t node = 0; node < read.size(); ++node) {
    weft::Vec3f own;  // x, y and z stand first in the 16 bytes of an element
    std::memcpy(&own, &copied[node * positions.stride], sizeof own);
    largest = std::max(largest, weft::length(own.to<double>() - read[node].to<double>()));
  }
  return largest;
}

weft::Result<void> run(const char* path, std::uint32_t frames, const char* picture) {
  const Gpu gpu;
  if (gpu.device == nullptr) return failure("There is no GPU device.");
  auto scene = weft::Scene::from_file(path);
  if (!scene) return scene.error();
  auto world = weft::World::create_on({gpu.adapter, gpu.device}, *scene);
  if (!world) return world.error();
  if (auto done = world->advance(frames); !done) return done;
  if (auto done = world->finish(); !done) return done;  // so that no frame is still to be repeated

  auto image = draw(gpu, *world);
  if (!image) return image.error();
  auto error = copy_error(gpu, *world);
  if (!error) return error.error();
  auto hash = world->state_hash();
  if (!hash) return hash.error();
  std::printf("%s %g\n", hash->c_str(), *error);
  return weft::write_png(picture, *image);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "own_device SCENE FRAMES PICTURE.png\n");
    return 2;
  }
  const weft::Result<void> result =
      run(argv[1], static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10)), argv[3]);
  if (!result) std::fprintf(stderr, "own_device: %s\n", result.error().message.c_str());
  return result ? 0 : 1;
}
