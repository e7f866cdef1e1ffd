#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "reference/simulation.hpp"
#include "sim/world.hpp"

namespace weft::cli {

/// The file frames.csv: a row a frame, written when the frame has ended, so that a run that is cut off leaves whole
/// rows. docs/cli.md lists the columns.
class FrameRows {
 public:
  /// Begins the file with its heading, or goes on behind the rows of the frames before this world's where they are
  /// there and have the same columns. `measures`: with what takes a read-back of each frame.
  /// Errors  Failure: the file cannot be read or written.
  static Result<FrameRows> create(const std::string& folder, const sim::World& world, bool measures);
  FrameRows(FrameRows&& other) noexcept;
  FrameRows& operator=(FrameRows&&) = delete;
  ~FrameRows();

  /// The row of the frame that has just ended.
  Result<void> add(sim::World& world);
  /// Goes on with another world of the run: removes the rows of its next frame and later ones.
  Result<void> go_on(const sim::World& world);

 private:
  Result<void> go_back_to(std::uint32_t frame);
  FrameRows(std::string path, int file) : path_(std::move(path)), file_(file) {}
  Result<void> append(const std::string& line);

  std::string path_, heading_;
  int file_ = -1;  // file descriptor
  std::optional<reference::MassSpringSystem>
      system_;  // where it measures: its elements, and room for a state
};

}  // namespace weft::cli
