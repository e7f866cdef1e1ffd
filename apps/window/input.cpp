#include "input.hpp"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cctype>
#include <utility>

#include "player/keys.hpp"

namespace weft::window {
namespace {

constexpr unsigned int kLastLetter = 0x7e;  // of ASCII

std::string name_of(int key) {
  switch (key) {
    case GLFW_KEY_LEFT:
      return "Left";
    case GLFW_KEY_RIGHT:
      return "Right";
    case GLFW_KEY_UP:
      return "Up";
    case GLFW_KEY_DOWN:
      return "Down";
    default:
      return {};
  }
}

Input& input_of(GLFWwindow* window) { return *static_cast<Input*>(glfwGetWindowUserPointer(window)); }

}  // namespace

void Input::listen() {
  GLFWwindow* window = toolkit_.window();
  glfwSetWindowUserPointer(window, this);
  glfwSetKeyCallback(window, [](GLFWwindow* any, int key, int, int action, int modifiers) {
    input_of(any).on_key(key, action, modifiers);
  });
  glfwSetCharCallback(window, [](GLFWwindow* any, unsigned int code) { input_of(any).on_letter(code); });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* any, int button, int action, int modifiers) {
    input_of(any).on_button(button, action, modifiers);
  });
  glfwSetCursorPosCallback(window, [](GLFWwindow* any, double x, double y) { input_of(any).on_move(x, y); });
  glfwSetScrollCallback(window,
                        [](GLFWwindow* any, double, double notches) { input_of(any).on_wheel(notches); });
  glfwSetDropCallback(window, [](GLFWwindow* any, int count, const char** paths) {
    input_of(any).on_drop(std::vector<std::string>(paths, paths + count));
  });
}

Result<void> Input::take(double wait) {
  wait > 0 ? glfwWaitEventsTimeout(wait) : glfwPollEvents();
  return std::exchange(failed_, Result<void>());
}

void Input::keep(const Result<void>& done) {
  const Result<void> left = player_.said(done);
  if (!left && failed_) failed_ = left;
}

void Input::act(const std::string& key, bool shift) {
  const Result<bool> done = act_on_key(player_, pointer_, key, shift);
  if (!done) keep(done.error());
}

void Input::on_key(int key, int action, int modifiers) {
  repeated_ = action == GLFW_REPEAT;
  if (action == GLFW_PRESS && commands_.question) return answer(key);
  if (action == GLFW_RELEASE || ImGui::GetIO().WantCaptureKeyboard) return;
  if ((modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0) return;
  if (const std::string name = name_of(key); !name.empty()) act(name, (modifiers & GLFW_MOD_SHIFT) != 0);
}

void Input::answer(int key) {
  if (key == GLFW_KEY_ESCAPE) commands_.question.reset();
  if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) keep(commands_.answer());
}

/// Letters and signs are those of the keyboard's layout; GLFW gives them after their key.
void Input::on_letter(unsigned int code) {
  if (ImGui::GetIO().WantCaptureKeyboard || code > kLastLetter) return;
  const auto lower = static_cast<char>(std::tolower(static_cast<int>(code)));
  const char letter = lower == '=' ? '+' : lower;
  if (repeated_ && letter != '+' && letter != '-') return;
  if (letter == 't') return panel_.toggle_theme();
  if (letter == '?') return panel_.toggle_help();
  const bool shift = glfwGetKey(toolkit_.window(), GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS ||
                     glfwGetKey(toolkit_.window(), GLFW_KEY_RIGHT_SHIFT) == GLFW_PRESS;
  act(std::string(1, letter), shift);
}

/// Dear ImGui knows where the pointer was in the last picture.
bool Input::over_picture() const { return !ImGui::GetIO().WantCaptureMouse && pointer_.clip().x < 1; }

void Input::on_button(int button, int action, int modifiers) {
  if (action == GLFW_RELEASE) return keep(pointer_.release());
  if (!over_picture()) return;
  if (button == GLFW_MOUSE_BUTTON_LEFT && (modifiers & GLFW_MOD_CONTROL) != 0) return pointer_.begin_area();
  keep(pointer_.press(button == GLFW_MOUSE_BUTTON_LEFT ? Pointer::Button::Left : Pointer::Button::Other,
                      (modifiers & GLFW_MOD_SHIFT) != 0, glfwGetTime()));
}

void Input::on_move(double x, double y) {
  const double pixels = toolkit_.pixels();
  pointer_.move({pixels * x, pixels * y}, glfwGetTime());
}

void Input::on_wheel(double notches) {
  if (over_picture()) pointer_.wheel(notches);
}

void Input::on_drop(const std::vector<std::string>& paths) { keep(commands_.open_files(paths)); }

}  // namespace weft::window
