#include "panel/theme.hpp"

namespace weft::window {

void apply_theme(bool dark, float scale) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  dark ? ImGui::StyleColorsDark(&style) : ImGui::StyleColorsLight(&style);
  style.AntiAliasedLinesUseTex = false;  // the overlay takes the nearest texel
  style.WindowRounding = 0;
  style.FrameRounding = 4;
  style.GrabRounding = 4;
  style.WindowPadding = {kMargin, kMargin};
  style.FramePadding = {8, 5};
  style.ItemSpacing = {8, 6};
  style.ScrollbarSize = 12;
  style.ScaleAllSizes(scale);
  const ImVec4 button = dark ? ImVec4{0.18F, 0.22F, 0.26F, 1} : ImVec4{0.88F, 0.91F, 0.94F, 1};
  const ImVec4 hovered = dark ? ImVec4{0.25F, 0.31F, 0.36F, 1} : ImVec4{0.79F, 0.85F, 0.89F, 1};
  const ImVec4 grab = dark ? ImVec4{0.25F, 0.65F, 0.78F, 1} : kChosen;
  auto& colors = style.Colors;
  colors[ImGuiCol_WindowBg] = colors[ImGuiCol_PopupBg] =
      dark ? ImVec4{0.09F, 0.11F, 0.13F, 1} : ImVec4{0.98F, 0.99F, 1, 1};
  colors[ImGuiCol_Button] = colors[ImGuiCol_FrameBg] = colors[ImGuiCol_Header] = button;
  colors[ImGuiCol_ButtonHovered] = colors[ImGuiCol_FrameBgHovered] = hovered;
  colors[ImGuiCol_HeaderHovered] = colors[ImGuiCol_HeaderActive] = colors[ImGuiCol_FrameBgActive] = hovered;
  colors[ImGuiCol_ButtonActive] = kChosen;
  colors[ImGuiCol_SliderGrab] = colors[ImGuiCol_SliderGrabActive] = colors[ImGuiCol_CheckMark] = grab;
  colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = button;
  colors[ImGuiCol_TextDisabled] = dark ? ImVec4{0.60F, 0.65F, 0.70F, 1} : ImVec4{0.35F, 0.40F, 0.46F, 1};
  colors[ImGuiCol_PlotLines] = grab;
}

}  // namespace weft::window
