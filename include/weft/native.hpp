// A World beside the caller's own use of the GPU: on a device of the caller's, into its textures, from weft's buffers.
// Not part of weft/weft.hpp. The handles are those of WebGPU's C interface as wgpu-native implements it; a program
// includes its webgpu.h, links weft::wgpu_native, and may include the two headers in either order.
//
// weft never destroys what is the caller's. A function of a World may not run while another thread calls a function of
// the same device: what goes wrong there would be taken for weft's.
#pragma once

#include <cstddef>
#include <cstdint>

#include "weft/world.hpp"

typedef struct WGPUAdapterImpl* WGPUAdapter;
typedef struct WGPUBufferImpl* WGPUBuffer;
typedef struct WGPUDeviceImpl* WGPUDevice;
typedef struct WGPUTextureImpl* WGPUTexture;

namespace weft {

/// A device and the adapter that it was asked of. World::create_on keeps a reference to each for as long as its World
/// lives; handles that World::native_device gives are valid for as long, unless the caller adds references of its own.
///
/// No feature is needed; timestamp-query gives times of passes. Limits are enough where each is WebGPU's default; the
/// size of buffers and textures depends on the scene. Errors of weft's calls come as Results and not to the callback
/// for uncaptured errors; a loss of the device comes to the caller's callback, and as DeviceLost from weft's next call.
struct NativeDevice {
  WGPUAdapter adapter = nullptr;
  WGPUDevice device = nullptr;
};

/// One of a world's buffers. Its usages are Storage, CopySrc, CopyDst and Vertex, of triangles Index instead of Vertex;
/// writing to it is not for the caller.
///
/// | of          | an element                                               |
/// |-------------|----------------------------------------------------------|
/// | position    | x, y, z [m] and the inverse mass [1/kg], 0 where moved   |
/// | velocity    | x, y, z [m/s]; the fourth number is weft's own           |
/// | normal      | x, y, z, a unit vector; the fourth number is weft's own  |
/// | stretch     | length / rest length                                     |
/// | triangles   | three node numbers, u32                                  |
///
/// All but triangles are f32. The buffer holds the state at the end of the last frame, for commands that are submitted
/// after weft's and before the next call of a function of World that is not const: position and velocity have two
/// buffers each that take turns, and a frame may have to be repeated, which finish() waits for. The handle is valid for
/// as long as the World lives, unless the caller adds a reference of its own.
struct NativeBuffer {
  WGPUBuffer buffer = nullptr;
  std::uint64_t offset = 0;  // of the first element [byte]
  std::uint64_t stride = 0;  // from an element to the next [byte]: 16, of stretch 4, of triangles 12
  std::size_t count = 0;     // elements
};

/// A texture of the World's device to draw into, as a window's surface gives one: two-dimensional, one layer, one mip
/// level, one sample a pixel, with usage RenderAttachment, of format RGBA8Unorm, RGBA8UnormSrgb, BGRA8Unorm or
/// BGRA8UnormSrgb. All of them get the same bytes, which are in sRGB. Its size is the picture's.
struct NativeTarget {
  WGPUTexture texture = nullptr;
};

}  // namespace weft
