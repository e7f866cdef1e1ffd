#pragma once

#include <array>

#include "gpu/dispatch.hpp"
#include "method/pieces/free_pieces.hpp"
#include "method/solver.hpp"

namespace weft {

// Mirrors of those in src/method/pieces/piece.wgsl.
inline constexpr std::uint32_t kPieceChunk = 64;  // nodes
inline constexpr std::uint32_t kChunkWords = 4;
inline constexpr std::uint32_t kPieceColumns = 4;
inline constexpr std::uint32_t kTurnColumns = 2;

/// Gives every piece whose nodes all go free the momentum and the angular momentum that forces from outside give it in
/// the substep, by a motion as of a rigid body. Without pieces that could go free it records nothing.
/// Source  docs/momentum.md.
class PieceMotion {
 public:
  /// Of a method that moves ways, and knows what they are without elements, `aim` [m], and which nodes obstacles bear
  /// where it answers them (src/method/holds/node_holds.wgsl).
  /// Reads   steps; position[parity] [m]; aim.
  /// Writes  position[1 - parity]: the ways [m].
  /// Errors  Shader, Limit, OutOfMemory.
  static Result<PieceMotion> create_of_ways(const SolverInputs& inputs, const gpu::Buffer<Vec4f>& aim);
  /// Of a method that has ended its substep; with drag, air or gas it moves nothing.
  /// Reads   steps; position[parity] [m], velocity[parity] [m/s]; rest_position, motions.
  ///         position[1 - parity] [m].
  /// Writes  SolverInputs::predicted [m/s].
  /// Errors  Shader, Limit, OutOfMemory.
  /// `of`: Bodies, or before that Solids, which pairs of two bodies hold.
  static Result<PieceMotion> create_of_steps(const SolverInputs& inputs, PiecesOf of);
  void record(gpu::ComputePass& pass) const;

 private:
  /// Whether there are pieces at all.
  Result<bool> create_lists(const SolverInputs& inputs, PiecesOf of);

  gpu::Buffer<std::uint32_t> lists_;                  // src/method/pieces/chunks.wgsl
  gpu::Buffer<std::array<std::uint32_t, 2>> pieces_;  // the first chunk of each, and how many
  gpu::Buffer<Vec4f> sums_;                           // of chunks
  gpu::Buffer<Vec4f> turns_;                          // of pieces
  std::uint64_t lanes_ = 0;                           // of all chunks
  gpu::Dispatch sum_, turn_, move_;
};

}  // namespace weft
