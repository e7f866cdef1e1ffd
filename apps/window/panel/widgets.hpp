// The panel's rows, of Dear ImGui.
#pragma once

#include <cstdio>
#include <string>

namespace weft::window {

inline constexpr float kFontSize = 15;     // [point]
inline constexpr float kPanelWidth = 320;  // [point]

/// Points as they are on this display: a point is a fifteenth of the letters' height. Between begin and end of a
/// picture.
float points(float number);

/// "65,536"
std::string whole(double number);
/// As printf has it.
template <class... Values>
std::string text(const char* format, Values... values) {
  char made[160];
  std::snprintf(made, sizeof made, format, values...);
  return made;
}

void heading(const char* title);
/// A sentence in a quieter colour.
void remark(const std::string& sentence);
/// A name on the left; the next field is on its right, and leaves so much of the width free for a unit.
void row(const std::string& name, float free = 0);
/// A name on the left, its value on the right.
void reading(const char* name, const std::string& value);
/// Says what the last field means while the pointer is over it.
void tip(const std::string& meaning);
/// One of `of` buttons of a row.
bool button_across(const std::string& label, int of);
/// The same, in the colour of what is chosen.
bool chosen_button(const std::string& label, int of);

}  // namespace weft::window
