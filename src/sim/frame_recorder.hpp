#pragma once

#include <array>
#include <cstdint>

#include "base/recently_used.hpp"
#include "contact/scene_contact.hpp"
#include "gpu/command_list.hpp"
#include "method/solver.hpp"
#include "state/last_good.hpp"
#include "state/surface.hpp"

namespace weft::sim {

/// Records frames as flat lists of commands, each once. Phases: "step"; in it "search", the search for pairs of
/// features; "frame", once at its end. Its inputs must outlive it.
class FrameRecorder {
 public:
  FrameRecorder() = default;
  /// Errors  Failure: the solver breaks the contract of contact (contact/stages/stages.hpp).
  static Result<FrameRecorder> create(const State& state, const Solver& solver,
                                      const contact::SceneContact& contact, const LastGood& last_good,
                                      const Surface& surface);

  /// The commands of a frame of this many substeps that begins with this parity, valid until forget or until kMostKept
  /// other numbers of substeps have been asked for.
  const gpu::CommandList& commands(std::uint32_t parity, std::uint32_t substeps);
  /// Discards the lists: one of their buffers was reallocated, or contacts are to be counted.
  void forget() { lists_.clear(); }
  /// How often the state changes buffers in this many substeps.
  std::uint32_t turns_of(std::uint32_t substeps) const;

 private:
  void record(gpu::CommandList& list, std::uint32_t parity, std::uint32_t substeps) const;

  const State* state_ = nullptr;
  const Solver* solver_ = nullptr;
  const contact::SceneContact* contact_ = nullptr;
  const LastGood* last_good_ = nullptr;
  const Surface* surface_ = nullptr;
  // Numbers of substeps whose lists are kept: a mover that speeds up asks for another one in each frame.
  static constexpr std::size_t kMostKept = 8;
  RecentlyUsed<std::uint32_t, std::array<gpu::CommandList, 2>, kMostKept> lists_;  // by substeps, then parity
};

}  // namespace weft::sim
