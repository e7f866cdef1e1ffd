#include "toolkit.hpp"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <dlfcn.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "panel/widgets.hpp"

namespace weft::window {
namespace {

constexpr int kLeastWidth = 640, kLeastHeight = 400;  // of the window
constexpr char kFont[] = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

/// GLFW has a function for each window system that it was built for, and others have no name in it.
template <class Answer, class... Arguments>
Answer native(const char* name, Arguments... arguments) {
  const auto found = reinterpret_cast<Answer (*)(Arguments...)>(::dlsym(RTLD_DEFAULT, name));
  return found != nullptr ? found(arguments...) : Answer();
}

Error glfw_error(const char* what) {
  const char* why = nullptr;
  glfwGetError(&why);
  return make_error(ErrorKind::Failure, "%s: %s", what, why != nullptr ? why : "GLFW gives no reason.");
}

/// The overlay takes the nearest texel, so letters stand on whole ones.
void load_font(float pixels) {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  io.Fonts->Flags |= ImFontAtlasFlags_NoBakedLines;
  ImFontConfig config;
  config.OversampleH = config.OversampleV = 1;
  config.PixelSnapH = true;
  config.SizePixels = pixels;
  static constexpr ImWchar kRanges[] = {0x20, 0xff, 0x2010, 0x2026, 0};  // Latin, dashes, quotation marks
  std::error_code ignored;
  if (std::filesystem::exists(kFont, ignored))
    io.Fonts->AddFontFromFileTTF(kFont, pixels, &config, kRanges);
  else
    io.Fonts->AddFontDefault(&config);
}

}  // namespace

Toolkit::~Toolkit() {
  if (ImGui::GetCurrentContext() != nullptr) {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  if (window_ != nullptr) glfwDestroyWindow(window_);
  glfwTerminate();
}

Result<void> Toolkit::open(std::uint32_t width, std::uint32_t height) {
  if (glfwInit() != GLFW_TRUE) return glfw_error("There is no display to open a window on");
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  window_ = glfwCreateWindow(static_cast<int>(width), static_cast<int>(height), "weft", nullptr, nullptr);
  if (window_ == nullptr) return glfw_error("The window cannot be opened");
  glfwSetWindowSizeLimits(window_, kLeastWidth, kLeastHeight, GLFW_DONT_CARE, GLFW_DONT_CARE);
  return {};
}

void Toolkit::begin_panel() {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  follow_scale();
  ImGui_ImplGlfw_InitForOther(window_, true);
}

bool Toolkit::follow_scale() {
  const auto wanted = static_cast<float>(std::round(static_cast<double>(kFontSize) * points() * pixels()));
  if (wanted == letters_) return false;
  letters_ = wanted;
  load_font(wanted);
  ImGui::GetIO().FontGlobalScale = static_cast<float>(1 / pixels());
  return true;
}

Result<gpu::WindowHandles> Toolkit::handles() const {
  gpu::WindowHandles handles;
  handles.display = native<void*>("glfwGetX11Display");
  if (handles.display != nullptr) {
    handles.window = native<unsigned long>("glfwGetX11Window", window_);
    return handles;
  }
  handles.system = gpu::WindowHandles::System::Wayland;
  handles.display = native<void*>("glfwGetWaylandDisplay");
  handles.wl_surface = native<void*>("glfwGetWaylandWindow", window_);
  if (handles.display == nullptr)
    return make_error(ErrorKind::Failure,
                      "This GLFW knows neither X11 nor Wayland, and weft draws in no other window.");
  return handles;
}

double Toolkit::pixels() const {
  int pixels = 0, units = 0;
  glfwGetFramebufferSize(window_, &pixels, nullptr);
  glfwGetWindowSize(window_, &units, nullptr);
  return pixels > 0 && units > 0 ? static_cast<double>(pixels) / units : 1;
}

double Toolkit::points() const {
  float scale = 1;
  glfwGetWindowContentScale(window_, &scale, nullptr);
  return std::max(1.0, static_cast<double>(scale) / pixels());
}

}  // namespace weft::window
