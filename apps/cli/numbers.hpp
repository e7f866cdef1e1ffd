// Options that are whole numbers.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace weft::cli {

inline constexpr std::uint32_t kMostFrames = 1000000;

/// Says of "ten" that it is no number, not that it is out of range.
inline const CLI::Validator kWholeNumber(
    [](std::string& text) -> std::string {
      const std::string digits = text.substr(!text.empty() && text[0] == '-' ? 1 : 0);
      if (!digits.empty() && digits.find_first_not_of("0123456789") == std::string::npos) return {};
      return "\"" + text + "\" is not a whole number";
    },
    "");

/// An option for every N-th of something.
inline CLI::Option* add_every(CLI::App& command, const char* name, std::uint32_t& every, const char* what) {
  return command.add_option(name, every, what)
      ->check(kWholeNumber)
      ->check(CLI::Range(1U, kMostFrames))
      ->type_name("N");
}

}  // namespace weft::cli
