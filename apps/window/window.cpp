#include "window.hpp"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "panel/theme.hpp"
#include "panel/widgets.hpp"

namespace weft::window {
namespace {

constexpr double kIdle = 0.05;  // from one look at the events to the next where nothing moves [s]

/// What this thread has computed so far [s]: without the waiting for the display.
double thread_seconds() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

Window::Window(const Options& options)
    : options_(options),
      player_(options.read, options.build),
      commands_(player_, options.places),
      panel_(player_, commands_),
      input_(toolkit_, player_, commands_, panel_) {}

Result<End> Window::show() {
  WEFT_CHECK(open());
  const Result<void> ran = run();
  if (!ran && ran.error().kind != ErrorKind::Interrupted) return ran.error();
  WEFT_TRY(ended, end());
  if (!ran) return ran.error();
  return ended;
}

Result<void> Window::open() {
  WEFT_CHECK(toolkit_.open(options_.width, options_.height));
  input_.listen();
  toolkit_.begin_panel();
  measure();
  gpu::DeviceOptions device;
  device.adapter = options_.adapter;
  WEFT_CHECK(player_.begin(device, canvas_width(), height_, options_.view));
  WEFT_TRY(handles, toolkit_.handles());
  WEFT_CHECK(screen_.begin(player_.device(), handles, width_, height_));
  WEFT_CHECK(screen_.take_font(player_.canvas()));
  WEFT_CHECK(player_.open(options_.first));
  if (options_.record) WEFT_CHECK(player_.record(commands_.recording_folder()));
  player_.play(!options_.paused);
  return {};
}

// The loop

bool Window::ended() {
  if (glfwWindowShouldClose(toolkit_.window()) == GLFW_TRUE) return true;
  if (!options_.frames) return false;
  return player_.world().frame() >= *options_.frames || !player_.playing();  // it has diverged, as end() says
}

Result<void> Window::run() {
  double before = glfwGetTime(), worked = thread_seconds();
  bool drawn = false;
  while (!ended()) {
    if (options_.interrupted()) return make_error(ErrorKind::Interrupted, "Interrupted.");
    const bool icon = width_ == 0 || height_ == 0;
    WEFT_CHECK(input_.take(options_.frames && !icon ? 0
                           : icon                   ? kIdle
                                                    : std::min(kIdle, player_.until_due())));
    if (icon) {
      measure();
      continue;
    }
    const double now = glfwGetTime();
    player_.notice.wait(now - before);
    if (player_.playing() && std::exchange(drawn, true)) times_.push_back(now - before);
    panel_.rates.count(now - before, thread_seconds() - worked, player_.world().totals().frames);
    worked = thread_seconds();
    WEFT_CHECK(draw(now - before));
    before = now;
  }
  return {};
}

Result<void> Window::draw(double seconds) {
  WEFT_CHECK(follow_size());
  name_window();
  if (toolkit_.follow_scale()) WEFT_CHECK(screen_.take_font(player_.canvas()));
  apply_theme(panel_.dark(), static_cast<float>(toolkit_.points()));
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const Result<void> laid_out = panel_.draw(size.x, size.y);
  ImGui::Render();
  WEFT_CHECK(laid_out);
  WEFT_CHECK(input_.move_hand());
  WEFT_CHECK(player_.tick(seconds, options_.frames.has_value()));
  WEFT_CHECK(screen_.take_panel());
  return screen_.show();
}

// Its size and name

/// Whether it has changed.
bool Window::measure() {
  int width = 0, height = 0;
  glfwGetFramebufferSize(toolkit_.window(), &width, &height);
  const std::uint32_t before[] = {width_, height_};
  width_ = static_cast<std::uint32_t>(width);
  height_ = static_cast<std::uint32_t>(height);
  return width_ != before[0] || height_ != before[1];
}

/// The picture stands beside the panel [pixel].
std::uint32_t Window::canvas_width() const {
  const double panel = static_cast<double>(kPanelWidth) * toolkit_.points() * toolkit_.pixels();
  return static_cast<std::uint32_t>(std::max(1.0, std::round(width_ - panel)));
}

Result<void> Window::follow_size() {
  if (!measure() || width_ == 0 || height_ == 0) return {};
  WEFT_CHECK(screen_.resize(width_, height_));
  WEFT_CHECK(player_.resize(canvas_width(), height_));
  return screen_.set_picture(player_.canvas());
}

void Window::name_window() {
  std::string title = player_.shown().name + (player_.playing() ? " - weft" : " (paused) - weft");
  if (title != title_) glfwSetWindowTitle(toolkit_.window(), title.c_str());
  title_ = std::move(title);
}

// Its end

Result<End> Window::end() {
  End end;
  if (player_.recording()) WEFT_SET(end.recorded, player_.stop_recording());
  if (options_.frames) {
    WEFT_SET(end.state_hash, player_.state_hash());
    player_.play(false);
    WEFT_CHECK(draw(0));  // with the reports of the last frames
  }
  if (!options_.picture.empty()) WEFT_CHECK(screen_.write(options_.picture));
  end.frames = player_.world().frame();
  end.width = width_;
  end.height = height_;
  end.adapter = player_.device().adapter().name;
  if (times_.empty()) return end;
  const auto middle = times_.begin() + static_cast<std::ptrdiff_t>(times_.size() / 2);
  std::nth_element(times_.begin(), middle, times_.end());
  end.median_ms = 1e3 * *middle;
  return end;
}

}  // namespace weft::window
