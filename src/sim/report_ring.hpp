#pragma once

#include <array>
#include <optional>

#include "gpu/command_list.hpp"
#include "gpu/readback.hpp"
#include "state/state.hpp"

namespace weft::sim {

/// The report of a finished frame.
struct Report {
  std::uint32_t frame = 0;
  std::uint32_t attempt = 0;  // which submission of frames that were repeated it is of
  std::uint32_t parity = 0;   // of the state that the frame began with
  Statistics statistics;
};

/// Brings the statistics of frames to the host without waiting, of three frames at a time.
class ReportRing {
 public:
  ReportRing() = default;
  /// Errors  OutOfMemory.
  static Result<ReportRing> create(gpu::Device& device, const State& state);

  bool has_room() const;
  /// The commands that copy the statistics aside, for a frame that is submitted with them. Needs room.
  const gpu::CommandList& commands() const;
  /// Expects the report of the frame that was submitted with commands().
  void expect(std::uint32_t frame, std::uint32_t attempt, std::uint32_t parity);
  /// The report of the earliest frame under way, once it has arrived; with `wait`, waited for.
  /// Errors  DeviceLost: it does not arrive.
  Result<std::optional<Report>> take(gpu::Device& device, bool wait);
  /// Lets go of all that is under way.
  void drop();

 private:
  struct Slot {
    gpu::Readback readback;
    gpu::CommandList commands;
    std::uint32_t frame = 0, attempt = 0, parity = 0;
  };
  const Slot* free_slot() const;

  std::array<Slot, 3> slots_;
};

}  // namespace weft::sim
