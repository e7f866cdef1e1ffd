#pragma once

#include <memory>

#include "base/result.hpp"
#include "gpu/device.hpp"

namespace weft::gpu {

/// A window as the operating system names it.
struct WindowHandles {
  enum class System : std::uint8_t { X11, Wayland };

  System system = System::X11;
  void* display = nullptr;     // a Display or a wl_display
  std::uint64_t window = 0;    // of X11
  void* wl_surface = nullptr;  // of Wayland
};

/// What a device draws into to be seen in a window: another texture for each picture. Native only. The device and the
/// window must outlive it.
class WindowSurface {
 public:
  /// Errors  Failure: the system gives no surface, or this adapter cannot draw into it.
  static Result<WindowSurface> create(Device& device, const WindowHandles& window);
  WindowSurface(WindowSurface&&) noexcept;
  WindowSurface& operator=(WindowSurface&&) noexcept;
  ~WindowSurface();

  /// Its format: one that stores bytes as they are.
  TextureFormat format() const;
  /// The size of the pictures to come [pixel]. They are shown at the display's own pace. Errors  DeviceLost, Shader.
  Result<void> resize(std::uint32_t width, std::uint32_t height);
  /// The view to draw the next picture into; 0: the window takes none now. Errors  Failure, DeviceLost.
  Result<Id> begin();
  /// Shows what has been submitted since begin gave a view.
  Result<void> present();

 private:
  struct Parts;
  explicit WindowSurface(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace weft::gpu
