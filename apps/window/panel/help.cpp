#include <imgui.h>

#include "panel/over_picture.hpp"
#include "panel/widgets.hpp"

namespace weft::window {

void draw_help(bool& shown, float width, float height) {
  ImGui::SetNextWindowPos({width / 2, height / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::Begin("Pointer and keys", &shown,
               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoSavedSettings);
  constexpr std::pair<const char*, const char*> kKeys[] = {
      {"Space", "play or pause"},
      {".", "one frame"},
      {"R", "reset"},
      {"P, U", "pin or unpin under the pointer; remove all pins"},
      {"Shift and P", "pin or unpin all in the middle half of the picture"},
      {"1 to 6, X", "view; wireframe and back"},
      {"F", "reset camera"},
      {"Arrows", "turn the camera, with Shift move it"},
      {"+, -", "zoom"},
      {"T, ?", "dark or light; this help"},
      {"Left button", "pull the cloth, or turn the camera beside it; twice: pin or unpin"},
      {"Control", "with the left button: pin or unpin all in a rectangle"},
      {"Right button", "move the picture, as Shift and the left one"},
      {"Wheel", "zoom"}};
  for (const auto& [key, action] : kKeys) {
    ImGui::TextUnformatted(key);
    ImGui::SameLine(points(120));
    ImGui::TextUnformatted(action);
  }
  ImGui::End();
}

}  // namespace weft::window
