#include "panel/panel.hpp"

#include <imgui.h>

#include "panel/mesh_dialog.hpp"
#include "panel/over_picture.hpp"
#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace weft::window {

Result<void> Panel::draw(float width, float height) {
  const float beside = width - points(kPanelWidth);
  ImGui::SetNextWindowPos({beside, 0});
  ImGui::SetNextWindowSize({points(kPanelWidth), height});
  ImGui::Begin("weft", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  const Result<void> drawn = [&]() -> Result<void> {
    WEFT_CHECK(draw_transport(player_, rates));
    WEFT_CHECK(draw_scene(player_, commands_));
    WEFT_CHECK(draw_views(player_));
    WEFT_CHECK(draw_pins(player_));
    WEFT_CHECK(parameters_.draw());
    draw_readings(player_, rates);
    return draw_files(player_, commands_);
  }();
  ImGui::End();
  WEFT_CHECK(drawn);
  if (player_.has_world()) draw_over_picture(player_, beside, height);
  WEFT_CHECK(draw_notice(player_, beside, height));
  if (help_) draw_help(help_, beside, height);
  return draw_mesh_dialog(commands_);
}

}  // namespace weft::window
