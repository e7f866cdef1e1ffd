// The window of `weft view`.
#pragma once

#include <vector>

#include "input.hpp"
#include "options.hpp"
#include "screen.hpp"

namespace weft::window {

class Window {
 public:
  explicit Window(const Options& options);

  /// Opens it and returns once it is closed. Errors  Failure: there is no display. Those of the first scene; NoAdapter,
  /// DeviceLost, Interrupted.
  Result<End> show();

 private:
  Result<void> open();
  /// Until it is closed. Errors  DeviceLost, Interrupted.
  Result<void> run();
  bool ended();
  /// The next picture, so much later than the one before [s].
  Result<void> draw(double seconds);
  Result<void> follow_size();
  bool measure();
  std::uint32_t canvas_width() const;
  void name_window();
  Result<End> end();

  const Options& options_;
  Toolkit toolkit_;
  Player player_;
  Commands commands_;
  Panel panel_;
  Input input_;
  Screen screen_;
  std::uint32_t width_ = 0, height_ = 0;  // [pixel]
  std::string title_;
  std::vector<double> times_;  // from one picture to the next while the scene plays [s]
};

}  // namespace weft::window
