#include "gpu/window_surface.hpp"

#include <span>
#include <utility>

#include "gpu/native/context.hpp"

namespace weft::gpu {

namespace backend {
WGPUTextureFormat texture_format(TextureFormat format);  // pipelines.cpp
}

struct WindowSurface::Parts {
  backend::Context* context = nullptr;
  WGPUSurface surface = nullptr;
  TextureFormat format = TextureFormat::None;
  std::uint32_t width = 0, height = 0;
  WGPUTexture texture = nullptr;  // of the picture that is being drawn
  WGPUTextureView view = nullptr;

  void end_picture() {
    if (view != nullptr) wgpuTextureViewRelease(std::exchange(view, nullptr));
    if (texture != nullptr) wgpuTextureRelease(std::exchange(texture, nullptr));
  }
  ~Parts() {
    end_picture();
    if (surface != nullptr) wgpuSurfaceRelease(surface);
  }
};

namespace {

WGPUSurface make_surface(WGPUInstance instance, const WindowHandles& window) {
  WGPUSurfaceSourceXlibWindow x11 = WGPU_SURFACE_SOURCE_XLIB_WINDOW_INIT;
  x11.display = window.display;
  x11.window = window.window;
  WGPUSurfaceSourceWaylandSurface wayland = WGPU_SURFACE_SOURCE_WAYLAND_SURFACE_INIT;
  wayland.display = window.display;
  wayland.surface = window.wl_surface;
  WGPUSurfaceDescriptor descriptor = WGPU_SURFACE_DESCRIPTOR_INIT;
  descriptor.nextInChain = window.system == WindowHandles::System::X11 ? &x11.chain : &wayland.chain;
  return wgpuInstanceCreateSurface(instance, &descriptor);
}

/// Of the formats whose bytes are those that are stored, the first that the surface has.
TextureFormat plain_format(WGPUSurface surface, WGPUAdapter adapter) {
  WGPUSurfaceCapabilities can = WGPU_SURFACE_CAPABILITIES_INIT;
  wgpuSurfaceGetCapabilities(surface, adapter, &can);
  TextureFormat found = TextureFormat::None;
  for (const WGPUTextureFormat format : std::span(can.formats, can.formatCount)) {
    if (found != TextureFormat::None) break;
    if (format == WGPUTextureFormat_BGRA8Unorm) found = TextureFormat::Bgra8Unorm;
    if (format == WGPUTextureFormat_RGBA8Unorm) found = TextureFormat::Rgba8Unorm;
  }
  wgpuSurfaceCapabilitiesFreeMembers(can);
  return found;
}

}  // namespace

WindowSurface::WindowSurface(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
WindowSurface::WindowSurface(WindowSurface&&) noexcept = default;
WindowSurface& WindowSurface::operator=(WindowSurface&&) noexcept = default;
WindowSurface::~WindowSurface() = default;

Result<WindowSurface> WindowSurface::create(Device& device, const WindowHandles& window) {
  auto parts = std::make_unique<Parts>();
  parts->context = &device.context();
  if (parts->context->instance == nullptr)
    return make_error(ErrorKind::Failure, "A device that the caller made has no window.");
  parts->surface = make_surface(parts->context->instance, window);
  if (parts->surface == nullptr)
    return make_error(ErrorKind::Failure, "The window system gives no surface to draw into.");
  parts->format = plain_format(parts->surface, parts->context->adapter);
  if (parts->format == TextureFormat::None)
    return make_error(ErrorKind::Failure,
                      "Adapter %s cannot draw into this window; --adapter chooses another.",
                      device.adapter().name.c_str());
  return WindowSurface(std::move(parts));
}

TextureFormat WindowSurface::format() const { return parts_->format; }

Result<void> WindowSurface::resize(std::uint32_t width, std::uint32_t height) {
  parts_->width = width;
  parts_->height = height;
  WGPUSurfaceConfiguration configuration = WGPU_SURFACE_CONFIGURATION_INIT;
  configuration.device = parts_->context->device;
  configuration.format = backend::texture_format(parts_->format);
  configuration.usage = WGPUTextureUsage_RenderAttachment;
  configuration.width = width;
  configuration.height = height;
  configuration.presentMode = WGPUPresentMode_Fifo;
  backend::watched(*parts_->context, [&] { wgpuSurfaceConfigure(parts_->surface, &configuration); });
  return parts_->context->take_error();
}

Result<Id> WindowSurface::begin() {
  backend::Context& context = *parts_->context;
  for (int attempt = 0; attempt < 2; ++attempt) {
    WGPUSurfaceTexture got = WGPU_SURFACE_TEXTURE_INIT;
    backend::watched(context, [&] { wgpuSurfaceGetCurrentTexture(parts_->surface, &got); });
    WEFT_CHECK(context.take_error());
    parts_->texture = got.texture;
    switch (got.status) {
      case WGPUSurfaceGetCurrentTextureStatus_SuccessOptimal:
      case WGPUSurfaceGetCurrentTextureStatus_SuccessSuboptimal:
        parts_->view = backend::watched(context, [&] { return wgpuTextureCreateView(got.texture, nullptr); });
        WEFT_CHECK(context.take_error());
        return backend::id_of(parts_->view);
      case WGPUSurfaceGetCurrentTextureStatus_Outdated:
      case WGPUSurfaceGetCurrentTextureStatus_Lost:  // the window has another size now, or was moved elsewhere
        parts_->end_picture();
        WEFT_CHECK(resize(parts_->width, parts_->height));
        break;
      default:
        parts_->end_picture();
        if (got.status == WGPUSurfaceGetCurrentTextureStatus_Timeout) return Id{0};
        return make_error(ErrorKind::Failure, "The window gives no picture to draw into (status %d).",
                          static_cast<int>(got.status));
    }
  }
  return Id{0};
}

Result<void> WindowSurface::present() {
  backend::watched(*parts_->context, [&] { return wgpuSurfacePresent(parts_->surface); });
  parts_->end_picture();
  return parts_->context->take_error();
}

}  // namespace weft::gpu
