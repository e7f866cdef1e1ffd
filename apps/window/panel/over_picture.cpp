#include "panel/over_picture.hpp"

#include <imgui.h>

#include <algorithm>

#include "panel/theme.hpp"
#include "panel/widgets.hpp"
#include "render/color_map.hpp"
#include "render/field.hpp"

namespace weft::window {
namespace {

constexpr ImU32 kInk = IM_COL32(24, 32, 44, 255);
constexpr ImU32 kMarker = IM_COL32(255, 214, 64, 255);
constexpr std::size_t kManyPins = 50;  // whose markers are smaller

void draw_title(Player& player) {
  const std::string& title = player.world().scene().title;
  const std::string& shown = title.empty() ? player.shown().name : title;
  ImGui::GetBackgroundDrawList()->AddText({points(kMargin), points(kMargin)}, kInk, shown.c_str());
}

/// In the lower left corner, where colours are numbers.
void draw_legend(const render::Field& field, float width, float height) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float margin = points(kMargin), line = ImGui::GetTextLineHeight(), thick = points(8);
  const ImVec2 low = {margin, height - margin - 2 * line - points(14)};
  const float bar = std::min(points(240), width - 2 * margin);
  list.AddRectFilled({low.x - points(8), low.y - points(6)},
                     {low.x + bar + points(8), height - margin + points(4)}, IM_COL32(16, 20, 26, 200),
                     points(4));
  list.AddText(low, IM_COL32_WHITE, field.title);
  const float top = low.y + line + points(3);
  const std::size_t parts = render::kColorMapSize - 1;
  const auto color = [](std::size_t i) {
    const Vec3f& c = render::kColorMap[i];
    return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, 1});
  };
  for (std::size_t i = 0; i < parts; ++i) {
    const float left = low.x + bar * static_cast<float>(i) / static_cast<float>(parts);
    list.AddRectFilledMultiColor({left, top}, {left + bar / static_cast<float>(parts), top + thick}, color(i),
                                 color(i + 1), color(i + 1), color(i));
  }
  const std::string lowest = text("%.*f", field.decimals, field.range.lowest);
  const std::string highest = text("%.*f", field.decimals, field.range.highest);
  const float below = top + thick + points(1);
  list.AddText({low.x, below}, IM_COL32_WHITE, lowest.c_str());
  list.AddText({low.x + bar - ImGui::CalcTextSize(highest.c_str()).x, below}, IM_COL32_WHITE,
               highest.c_str());
}

void draw_markers(Player& player, float width, float height) {
  const float radius = points(player.pins().all().size() > kManyPins ? 3 : 6);
  for (const Pin& pin : player.pins().all()) {
    const render::Projected seen = player.look().project(pin.point);
    if (seen.depth <= 0) continue;
    const ImVec2 at = {width * static_cast<float>(seen.x + 1) / 2,
                       height * static_cast<float>(1 - seen.y) / 2};
    ImGui::GetBackgroundDrawList()->AddCircleFilled(at, radius, kMarker);
    ImGui::GetBackgroundDrawList()->AddCircle(at, radius, kInk, 0, points(1.5F));
  }
}

void draw_area(const render::PickArea& area, float width, float height) {
  const auto at = [&](double x, double y) {
    return ImVec2{width * static_cast<float>(x + 1) / 2, height * static_cast<float>(1 - y) / 2};
  };
  const ImVec2 a = at(area.ax, area.ay), b = at(area.bx, area.by);
  const ImVec2 low = {std::min(a.x, b.x), std::min(a.y, b.y)},
               high = {std::max(a.x, b.x), std::max(a.y, b.y)};
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled(low, high, IM_COL32(255, 214, 64, 40));
  list.AddRect(low, high, kInk, 0, 0, points(3));
  list.AddRect(low, high, kMarker, 0, 0, points(1.5F));
}

}  // namespace

void draw_over_picture(Player& player, float width, float height) {
  draw_title(player);
  if (const auto field = render::field_of(player.view())) draw_legend(*field, width, height);
  draw_markers(player, width, height);
  if (player.drawn_area) draw_area(*player.drawn_area, width, height);
}

}  // namespace weft::window
