#include <imgui.h>

#include <algorithm>

#include "panel/over_picture.hpp"
#include "panel/theme.hpp"
#include "panel/widgets.hpp"

namespace weft::window {
namespace {

ImVec4 color_of(Tone tone) {
  constexpr float kOpaque = 0.94F;
  switch (tone) {
    case Tone::Error:
      return {0.62F, 0.16F, 0.16F, kOpaque};
    case Tone::Warning:
      return {0.55F, 0.40F, 0.05F, kOpaque};
    case Tone::Plain:
      break;
  }
  return {0.10F, 0.25F, 0.32F, kOpaque};
}

}  // namespace

Result<void> draw_notice(Player& player, float width, float height) {
  const std::string sentence = player.notice.sentence();
  if (sentence.empty()) return {};
  const float margin = points(kMargin);
  ImGui::SetNextWindowPos({width / 2, height - 3 * margin}, ImGuiCond_Always, {0.5F, 1});
  ImGui::SetNextWindowSize({std::min(points(640), width - 4 * margin), 0});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, color_of(player.notice.tone()));
  ImGui::PushStyleColor(ImGuiCol_Text, {1, 1, 1, 1});
  ImGui::PushStyleColor(ImGuiCol_Button, {1, 1, 1, 0.18F});
  ImGui::Begin("notice", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::TextWrapped("%s", sentence.c_str());
  const bool close = ImGui::Button("Close");
  bool remedy = false;
  if (player.has_world() && sentence == player.facts().unstable_step) {
    ImGui::SameLine();
    remedy = ImGui::Button("Use \"auto\"");
  }
  ImGui::End();
  ImGui::PopStyleColor(3);
  if (close) player.notice.close();
  return remedy ? player.change({{"time.substeps", "\"auto\""}}) : Result<void>();
}

}  // namespace weft::window
