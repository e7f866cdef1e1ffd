#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "altered.hpp"
#include "run.hpp"
#include "run_results.hpp"
#include "summary.hpp"

namespace weft::cli {

/// A scene that is being simulated, from its start or from a checkpoint, with what it writes. Where the device is lost,
/// it can go back to its last checkpoint.
class SceneRun {
 public:
  SceneRun(const RunOptions& options, scene::Scene scene, Assets assets)
      : options_(options), scene_(std::move(scene)), assets_(std::move(assets)), faults_(options.faults) {}

  /// Makes the world, as the checkpoint of --resume has it where there is one; and then the folder of results.
  /// Errors  NoAdapter, Limit, OutOfMemory, Shader, DeviceLost; Input: the checkpoint; those of RunResults::create.
  Result<void> begin();
  /// Simulates up to the last frame, and writes what belongs to frames.
  /// Errors  Interrupted, Diverged, after which results can be written; DeviceLost, OutOfMemory, Failure.
  Result<void> simulate();
  /// Whether there is a checkpoint that no lost device has gone back to yet.
  bool can_go_back() const { return checkpoint_ && checkpoint_->snapshot.time.frame > gone_back_to_; }
  /// Makes a device and a world again, as the last checkpoint has it.
  Result<void> go_back();

  sim::World& world() { return *world_; }
  RunResults* results() { return results_.get(); }
  const Altered& altered() const { return altered_; }
  Summary& summary() { return summary_; }

 private:
  Result<void> make_world();
  /// Sews on and tears what is due before the next frame.
  Result<void> change_mesh();
  Result<void> resume();
  Result<void> advance();
  Result<void> keep_checkpoint();
  Result<void> simulate_frames();
  /// Whether a fault of this kind is to come about before this frame; it does so once.
  bool strikes(const char* kind, std::uint32_t frame);

  const RunOptions& options_;
  scene::Scene scene_;
  Assets assets_;
  std::vector<std::string> faults_;
  std::unique_ptr<gpu::Device> device_;
  std::unique_ptr<sim::World> world_;
  std::unique_ptr<RunResults> results_;  // draws with the world: goes before it
  std::optional<sim::SavedState> checkpoint_;
  std::int64_t gone_back_to_ = -1;  // frame
  std::uint32_t furthest_ = 0;      // frames that were simulated, also those that are simulated again
  bool tangled_ = false;
  Altered altered_;
  Summary summary_;
};

}  // namespace weft::cli
