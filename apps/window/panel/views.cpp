#include <imgui.h>

#include <cctype>

#include "panel/sections.hpp"
#include "panel/widgets.hpp"
#include "scene/names.hpp"

namespace weft::window {
namespace {

std::string capital(std::string word) {
  word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
  return word;
}

}  // namespace

Result<void> draw_views(Player& player) {
  heading("View");
  std::optional<scene::View> chosen;
  std::string refused;
  for (std::size_t i = 0; i < std::size(scene::kViewNames); ++i) {
    const auto view = static_cast<scene::View>(i);
    const std::string why = player.refusal(view);
    if (!why.empty() && player.has_world()) refused += (refused.empty() ? "" : " ") + why;
    const std::string name = capital(scene::kViewNames[i]);
    if (i % 2 == 1) ImGui::SameLine();
    ImGui::BeginDisabled(!why.empty());
    if (view == player.view() ? chosen_button(name, 2) : button_across(name, 2)) chosen = view;
    ImGui::EndDisabled();
  }
  if (!refused.empty()) remark(refused);
  if (chosen) WEFT_CHECK(player.set_view(*chosen));
  if (button_across("Reset camera", 1) && player.has_world()) player.reset_camera();
  return {};
}

Result<void> draw_pins(Player& player) {
  heading("Pins");
  const std::size_t count = player.pins().all().size();
  remark(count == 0 ? text("Double-click the cloth, press P over it, or draw a rectangle with Control: up to "
                           "%zu nodes stay where they are.",
                           Pins::most())
                    : text("%zu of %zu pinned. Drag a pin to move it.", count, Pins::most()));
  ImGui::BeginDisabled(count == 0);
  const bool remove = button_across("Remove all", 1);
  ImGui::EndDisabled();
  return remove ? player.pins().remove_all() : Result<void>();
}

}  // namespace weft::window
