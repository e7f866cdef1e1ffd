#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "contact/scene_contact.hpp"
#include "gpu/command_list.hpp"
#include "method/solver.hpp"
#include "state/last_good.hpp"
#include "state/surface.hpp"

namespace weft::sim {

/// Records frames as flat lists of commands, each once. Phases: "step"; in it "search", what looks for pairs of
/// features; "frame", once at its end. What it is made of must outlive it.
class FrameRecorder {
 public:
  FrameRecorder() = default;
  /// Errors  Failure: the solver breaks the contract of contact (contact/stages/stages.hpp).
  static Result<FrameRecorder> create(const State& state, const Solver& solver,
                                      const contact::SceneContact& contact, const LastGood& last_good,
                                      const Surface& surface);

  /// The commands of a frame of this many substeps that begins with this parity, until the next call of forget or of
  /// this with another number of substeps.
  const gpu::CommandList& commands(std::uint32_t parity, std::uint32_t substeps);
  /// Discards what is recorded: a buffer that it names was made again, or contacts are to be counted.
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
  std::map<std::uint32_t, std::array<gpu::CommandList, 2>> lists_;  // by substeps and parity, once needed
};

}  // namespace weft::sim
