#include "panel/widgets.hpp"

#include <imgui.h>

#include <cmath>

#include "panel/theme.hpp"

namespace weft::window {

float points(float number) { return number * ImGui::GetFontSize() / kFontSize; }

std::string whole(double number) {
  std::string digits = std::to_string(static_cast<long long>(std::llround(number)));
  for (int at = static_cast<int>(digits.size()) - 3; at > (digits[0] == '-' ? 1 : 0); at -= 3)
    digits.insert(static_cast<std::size_t>(at), ",");
  return digits;
}

void heading(const char* title) {
  ImGui::Dummy({0, points(4)});
  ImGui::TextDisabled("%s", title);
}

void remark(const std::string& sentence) {
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::TextWrapped("%s", sentence.c_str());
  ImGui::PopStyleColor();
}

void row(const std::string& name, float free) {
  constexpr float kNames = 0.52F, kLongNames = 0.6F;  // parts of the width
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name.c_str());
  ImGui::SameLine((free > 0 ? kLongNames : kNames) * ImGui::GetWindowContentRegionMax().x);
  ImGui::SetNextItemWidth(free > 0 ? -free : -1);
}

void reading(const char* name, const std::string& value) {
  ImGui::TextUnformatted(name);
  const float right = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(value.c_str()).x;
  ImGui::SameLine(right);
  ImGui::TextUnformatted(value.c_str());
}

void tip(const std::string& meaning) {
  if (meaning.empty() || !ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(points(kPanelWidth));
  ImGui::TextUnformatted(meaning.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

bool button_across(const std::string& label, int of) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float all = ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
  return ImGui::Button(
      label.c_str(), {(all - static_cast<float>(of - 1) * style.ItemSpacing.x) / static_cast<float>(of), 0});
}

bool chosen_button(const std::string& label, int of) {
  ImGui::PushStyleColor(ImGuiCol_Button, kChosen);
  ImGui::PushStyleColor(ImGuiCol_Text, {1, 1, 1, 1});
  const bool pressed = button_across(label, of);
  ImGui::PopStyleColor(2);
  return pressed;
}

}  // namespace weft::window
