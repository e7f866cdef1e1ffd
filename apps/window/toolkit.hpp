#pragma once

#include <cstdint>

#include "gpu/window_surface.hpp"

struct GLFWwindow;

namespace weft::window {

/// GLFW's window and Dear ImGui in it, from begin to end.
class Toolkit {
 public:
  Toolkit() = default;
  Toolkit(const Toolkit&) = delete;
  Toolkit& operator=(const Toolkit&) = delete;
  ~Toolkit();

  /// Errors  Failure: there is no display, or it opens no window.
  Result<void> open(std::uint32_t width, std::uint32_t height);
  /// After the window's own callbacks are set: Dear ImGui calls them too.
  void begin_panel();
  /// Whether letters are of other pixels from now on: the window is on another display, or GLFW knows its display now.
  bool follow_scale();

  GLFWwindow* window() const { return window_; }
  /// The window as the operating system names it. Errors  Failure: it is one of neither X11 nor Wayland.
  Result<gpu::WindowHandles> handles() const;
  /// Pixels of one of the window's units, in which GLFW gives places.
  double pixels() const;
  /// What a point is of the window's units: more than 1 where X11 asks for larger letters.
  double points() const;

 private:
  GLFWwindow* window_ = nullptr;
  float letters_ = 0;  // how high they are [pixel]
};

}  // namespace weft::window
