#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gpu/window_surface.hpp"
#include "overlay/overlay.hpp"

namespace weft::window {

/// What is drawn into the window: the picture of the cloth, and over it what Dear ImGui has laid out.
class Screen {
 public:
  /// Errors  those of WindowSurface::create.
  Result<void> begin(gpu::Device& device, const gpu::WindowHandles& window, std::uint32_t width,
                     std::uint32_t height);
  /// Draws Dear ImGui's letters as they are now, over this picture in the upper left corner.
  /// Errors  those of Overlay::create.
  Result<void> take_font(const gpu::Texture& picture);
  /// Errors  DeviceLost, Shader.
  Result<void> resize(std::uint32_t width, std::uint32_t height);
  /// The picture from now on, in the upper left corner. Errors  Shader.
  Result<void> set_picture(const gpu::Texture& picture) { return overlay_.set_picture(picture, 0, 0); }

  /// Takes over what ImGui::Render has made. Errors  OutOfMemory, Limit.
  Result<void> take_panel();
  /// Shows all of it. Errors  Failure, DeviceLost.
  Result<void> show();
  /// Writes what was shown last as a PNG file. Errors  Failure: it cannot be written. DeviceLost.
  Result<void> write(const std::string& path);

 private:
  gpu::Device* device_ = nullptr;
  std::optional<gpu::WindowSurface> surface_;
  overlay::Overlay overlay_;
  gpu::CommandList list_;
  std::vector<overlay::Vertex> vertices_;
  std::vector<Vec4f> clips_;
  std::uint32_t width_ = 0, height_ = 0;  // [pixel]
};

}  // namespace weft::window
