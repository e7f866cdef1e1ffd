#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/world.hpp"

namespace weft::cli {

/// The summary of a run; docs/cli.md lists the members.
struct Summary {
  std::string scene;                            // the path as given
  std::string end = "complete";                 // or "interrupted", "diverged"
  std::optional<std::uint32_t> resumed_frames;  // after which it went on from a checkpoint
  std::vector<double> frame_ms;                 // of its own frames, simulation alone [ms]
  double wall_s = 0;                            // pictures included [s]
  std::string state_hash;
};

std::string summary_json(const Summary& summary, const sim::World& world);
/// For people: a few lines.
std::string summary_text(const Summary& summary, const sim::World& world);

}  // namespace weft::cli
