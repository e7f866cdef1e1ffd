#include "panel/parameters.hpp"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "panel/widgets.hpp"
#include "player/air.hpp"
#include "player/key_limits.hpp"

namespace weft::window {
namespace {

constexpr char kWind[] = "wind.velocity";
constexpr char kColor[] = "cloths.0.color";
constexpr Vec3d kGrey{0.7, 0.7, 0.7};  // shown where the colour is the look's
constexpr float kUnit = 52;            // what the longest unit takes [point]
constexpr double kDigits = 1e3;        // a slider's values have three decimals

Vec3d vector_of(const Json* value) {
  if (value == nullptr || value->values.size() != 3) return {};
  return {value->values[0].number, value->values[1].number, value->values[2].number};
}
double strength_of(const Json* value) {
  if (value == nullptr) return 0;
  return value->kind == Json::Kind::List ? length(vector_of(value)) : value->number;
}
std::string list_text(const Vec3d& v) {
  return "[" + number_text(v.x) + "," + number_text(v.y) + "," + number_text(v.z) + "]";
}

std::string lower(std::string words) {
  std::transform(words.begin(), words.end(), words.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return words;
}

/// Of a number as it is, of a vector its strength; none: it has not been moved.
std::optional<double> moved_strength(const SceneValues& values, const Parameter& parameter) {
  const std::optional<KeyLimits>& limits = limits_of(parameter.key);
  const double now = strength_of(values.now(parameter.key));
  const double own = strength_of(values.own(parameter.key));
  const double least = std::max(0.0, limits->least);
  const double most = std::min(limits->most, std::ceil(std::max({parameter.reach, 2 * own, now})));
  auto value = static_cast<float>(now);
  row(parameter.label);
  const std::string format = limits->unit.empty() ? "%.2f" : "%.2f " + limits->unit;
  const bool moved =
      ImGui::SliderFloat(("##" + parameter.key).c_str(), &value, static_cast<float>(least),
                         static_cast<float>(most), format.c_str(), ImGuiSliderFlags_AlwaysClamp);
  tip(limits->meaning);
  return moved ? std::optional(std::round(static_cast<double>(value) * kDigits) / kDigits) : std::nullopt;
}

}  // namespace

Result<void> Parameters::draw() {
  if (!player_.has_world()) return {};
  for (const ParameterGroup& group : parameter_groups())
    if (ImGui::CollapsingHeader(group.title.c_str(), group.live ? ImGuiTreeNodeFlags_DefaultOpen : 0))
      WEFT_CHECK(draw_group(group));
  return {};
}

Result<void> Parameters::draw_group(const ParameterGroup& group) {
  const auto has = [&](const std::string& key) { return player_.values().now(key) != nullptr; };
  Edits back;
  for (const Parameter& each : group.parameters) {
    const std::optional<KeyLimits>& limits = limits_of(each.key);
    if (!limits || !applies(each.key, has)) continue;
    if (player_.values().changed(each.key)) back[each.key] = std::nullopt;
    if (!limits->numeric)
      WEFT_CHECK(draw_choice(each, group.live));
    else if (each.key == kColor)
      WEFT_CHECK(draw_color(each));
    else
      WEFT_CHECK(!group.live ? draw_number(each) : each.key == kWind ? draw_wind(each) : draw_slider(each));
  }
  if (group.name == "wind" && strength_of(player_.values().now("drag")) == 0 && !has("air"))
    remark("Wind pulls by the air's drag, which is 0 here: raise it to feel the wind.");
  if (back.empty() || !button_across("Reset " + lower(group.title), 1)) return {};
  return group.live ? player_.change_live(back) : player_.change(back);
}

Result<void> Parameters::draw_slider(const Parameter& parameter) {
  const std::optional<double> strength = moved_strength(player_.values(), parameter);
  if (!strength) return {};
  const Json* own = player_.values().own(parameter.key);
  const bool is_vector = own != nullptr && own->kind == Json::Kind::List;
  return player_.change_live(
      {{parameter.key, is_vector ? list_text(scaled(vector_of(own), *strength)) : number_text(*strength)}});
}

/// A vector by its strength and its direction.
Result<void> Parameters::draw_wind(const Parameter& parameter) {
  const Vec3d now = vector_of(player_.values().now(parameter.key));
  if (length(now) > 0 && !ImGui::IsAnyItemActive()) heading_ = heading_of(now);
  const std::optional<double> speed = moved_strength(player_.values(), parameter);
  auto degrees = static_cast<float>(heading_);
  row("Direction");
  const bool turned =
      ImGui::SliderFloat("##heading", &degrees, -180, 180, "%.0f°", ImGuiSliderFlags_AlwaysClamp);
  tip("Where it blows to, about the vertical: 90° is along x.");
  if (turned) heading_ = std::round(static_cast<double>(degrees));
  if (!speed && !turned) return {};
  const Vec3d own = vector_of(player_.values().own(parameter.key));
  return player_.change_live(
      {{parameter.key, list_text(blowing(speed.value_or(length(now)), heading_, own))}});
}

/// One of the schema's words. What stood in its place, but for what only looks, goes with it.
Result<void> Parameters::draw_choice(const Parameter& parameter, bool live) {
  const KeyLimits& limits = *limits_of(parameter.key);
  const Json* now = player_.values().now(parameter.key);
  const bool is_word = now != nullptr && now->kind == Json::Kind::Text;
  std::optional<std::string> chosen;
  row(parameter.label);
  if (ImGui::BeginCombo(("##" + parameter.key).c_str(),
                        is_word ? now->text.c_str() : "as the scene has it")) {
    for (const std::string& word : limits.choices)
      if (ImGui::Selectable(word.c_str(), is_word && word == now->text)) chosen = word;
    ImGui::EndCombo();
  }
  tip(limits.meaning);
  if (!chosen) return {};
  if (live) return player_.change_live({{parameter.key, json_text(*chosen)}});
  Edits edits;
  for (const auto& [key, value] : player_.shown().set)
    for (const std::string& gone : parameter.clears)
      if (is_within(key, gone) && key != kColor && key != "cloths.0.look") edits[key] = std::nullopt;
  edits["time.substeps"] = std::nullopt;
  edits[parameter.key] = json_text(*chosen);
  return player_.change(edits);
}

Result<void> Parameters::draw_color(const Parameter& parameter) {
  const Json* now = player_.values().now(parameter.key);
  const Vec3d color = now != nullptr ? vector_of(now) : kGrey;
  float parts[] = {static_cast<float>(color.x), static_cast<float>(color.y), static_cast<float>(color.z)};
  row(parameter.label);
  const bool moved = ImGui::ColorEdit3(("##" + parameter.key).c_str(), parts, ImGuiColorEditFlags_NoInputs);
  tip(limits_of(parameter.key)->meaning);
  if (!moved) return {};
  const auto digits = [](float part) { return std::round(static_cast<double>(part) * kDigits) / kDigits; };
  return player_.change_live(
      {{parameter.key, list_text({digits(parts[0]), digits(parts[1]), digits(parts[2])})}});
}

/// A number, or a word that stands for one: nothing in the field.
Result<void> Parameters::draw_number(const Parameter& parameter) {
  const KeyLimits& limits = *limits_of(parameter.key);
  const Json* now = player_.values().now(parameter.key);
  const auto typed = typed_.find(parameter.key);
  const std::string before =
      now != nullptr && now->kind == Json::Kind::Number ? number_text(now->number) : std::string();
  char entered[64];
  std::snprintf(entered, sizeof entered, "%s", (typed != typed_.end() ? typed->second : before).c_str());
  row(parameter.label, points(kUnit));
  ImGui::InputTextWithHint(("##" + parameter.key).c_str(),
                           limits.choices.empty() ? "" : limits.choices.front().c_str(), entered,
                           sizeof entered);
  tip(limits.meaning + " From " + number_text(limits.least) + " to " + number_text(limits.most) + ".");
  const bool active = ImGui::IsItemActive(), entered_now = ImGui::IsItemDeactivatedAfterEdit();
  ImGui::SameLine();
  ImGui::TextUnformatted(limits.unit.c_str());
  if (active) {
    typed_[parameter.key] = entered;
    return {};
  }
  typed_.erase(parameter.key);
  if (!entered_now || entered == before) return {};
  const Result<std::string> value = parsed(limits, parameter.label, entered);
  if (value) return player_.change({{parameter.key, *value}});
  player_.notice.say(value.error().message, Tone::Plain);
  return {};
}

}  // namespace weft::window
