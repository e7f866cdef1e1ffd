#pragma once

#include <memory>
#include <optional>
#include <string>

#include "frame_rows.hpp"
#include "out_folder.hpp"
#include "pictures.hpp"
#include "run.hpp"
#include "summary.hpp"

namespace weft::cli {

/// What a run writes into its folder.
class RunResults {
 public:
  /// Takes the folder, unless something is refused: then it is not even made.
  /// Errors  Shader, Limit, OutOfMemory; Failure where the folder cannot be written or is in use.
  static Result<std::unique_ptr<RunResults>> create(sim::World& world, const RunOptions& options);

  /// Writes what belongs to the frame that has just ended.
  Result<void> add_frame(sim::World& world);
  Result<void> write_checkpoint(const sim::SavedState& state);
  /// Before the world and its device go: they are lost.
  void let_go();
  /// Waits for what is drawn with a world that goes.
  Result<void> settle();
  /// The same run in another world, whose frames may have been there already.
  Result<void> go_on(sim::World& world);
  /// Waits until all pictures are written.
  Result<void> finish_pictures();
  Result<void> write_end(sim::World& world, const sim::Snapshot& snapshot, const Summary& summary);
  /// "3 pictures, run.mp4, final.obj, summary.json"
  std::string listed() const;

 private:
  OutFolder folder_;  // given back last
  std::uint32_t meshes_every_ = 0, meshes_ = 0, checkpoints_ = 0;
  std::string mesh_format_;
  std::unique_ptr<Pictures> pictures_;
  std::optional<FrameRows> rows_;

  RunResults(OutFolder folder, const RunOptions& options, std::unique_ptr<Pictures> pictures)
      : folder_(std::move(folder)),
        meshes_every_(options.meshes_every),
        mesh_format_(options.mesh_format),
        pictures_(std::move(pictures)) {}
};

}  // namespace weft::cli
