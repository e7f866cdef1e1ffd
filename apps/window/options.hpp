#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "player/commands.hpp"

namespace weft::window {

struct Options {
  Wanted first;
  Reader read;
  std::string build;  // as saved states name what they come from
  Places places;
  std::function<bool()> interrupted;
  scene::View view = scene::View::Textured;
  std::string adapter;
  std::uint32_t width = 1280, height = 800;  // [point]
  bool paused = false;
  std::optional<std::uint32_t> frames;  // closes after so many, one a picture, however long each takes
  std::string picture;                  // a file for the window's last picture; empty: none
  bool record = false;                  // from the first frame on
};

/// How it went.
struct End {
  std::uint32_t frames = 0;
  std::string state_hash;               // where `frames` were asked for
  std::uint32_t width = 0, height = 0;  // of the window's pictures [pixel]
  double median_ms = 0;  // from one picture to the next, while the scene played; 0: there was one
  std::string adapter;
  std::string recorded;  // a sentence, where the end of the window ended a recording
};

}  // namespace weft::window
