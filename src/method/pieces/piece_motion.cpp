#include "method/pieces/piece_motion.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace weft {

Result<bool> PieceMotion::create_lists(const SolverInputs& inputs, PiecesOf of) {
  const FreePieces free = free_pieces(inputs.model.host, of);
  if (free.count() == 0) return false;
  std::vector<std::uint32_t> lists;
  std::vector<std::array<std::uint32_t, 2>> pieces;
  for (std::uint32_t piece = 0; piece < free.count(); ++piece) {
    const auto first_chunk = static_cast<std::uint32_t>(lists.size() / kChunkWords);
    for (std::uint32_t at = free.starts[piece]; at < free.starts[piece + 1]; at += kPieceChunk)
      for (const std::uint32_t word :
           {at, std::min(kPieceChunk, free.starts[piece + 1] - at), piece, free.nodes[free.starts[piece]]})
        lists.push_back(word);
    pieces.push_back({first_chunk, static_cast<std::uint32_t>(lists.size() / kChunkWords) - first_chunk});
  }
  const std::size_t chunks = lists.size() / kChunkWords;
  lanes_ = std::uint64_t{kPieceChunk} * chunks;
  lists.insert(lists.end(), free.nodes.begin(), free.nodes.end());
  gpu::Device& device = inputs.device;
  WEFT_SET(lists_, gpu::Buffer<std::uint32_t>::create_from(device, lists, "nodes of free pieces"));
  using Chunks = std::array<std::uint32_t, 2>;
  WEFT_SET(pieces_, gpu::Buffer<Chunks>::create_from(device, pieces, "free pieces"));
  WEFT_SET(sums_, gpu::Buffer<Vec4f>::create(device, kPieceColumns * chunks, "sums of pieces"));
  WEFT_SET(turns_, gpu::Buffer<Vec4f>::create(device, kTurnColumns * pieces.size(), "turns of pieces"));
  WEFT_TRY(turn,
           gpu::create_shared_kernel(device, "method/pieces/turn_pieces.wgsl", {}, inputs.workgroup_size));
  WEFT_SET(turn_, gpu::Dispatch::create(
                      turn, turn->workgroups_of(std::uint64_t{inputs.workgroup_size} * pieces.size()),
                      {pieces_, sums_, turns_}));
  return true;
}

Result<PieceMotion> PieceMotion::create_of_ways(const SolverInputs& inputs, const gpu::Buffer<Vec4f>& aim) {
  PieceMotion made;
  WEFT_TRY(any, made.create_lists(inputs, PiecesOf::Elements));
  if (!any) return made;
  const State& state = inputs.state;
  const bool holds = inputs.presses() != nullptr;
  const char* shader = holds ? "method/holds/sum_held_ways.wgsl" : "method/pieces/sum_ways.wgsl";
  WEFT_TRY(sum, gpu::create_shared_kernel(inputs.device, shader, {}, inputs.workgroup_size));
  WEFT_SET(made.sum_, gpu::Dispatch::create_by_parity(sum, sum->workgroups_of(made.lanes_),
                                                      [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                                        gpu::Dispatch::Bindings all{
                                                            made.lists_, state.position[p], aim,
                                                            state.position[1 - p], made.sums_};
                                                        if (holds) all.insert(all.begin(), state.steps);
                                                        return all;
                                                      }));
  WEFT_TRY(move, gpu::create_shared_kernel(inputs.device, "method/pieces/move_ways.wgsl", {},
                                           inputs.workgroup_size));
  WEFT_SET(made.move_,
           gpu::Dispatch::create_by_parity(
               move, move->workgroups_of(made.lanes_), [&](std::size_t p) -> gpu::Dispatch::Bindings {
                 return {made.lists_, made.sums_, made.turns_, state.position[p], state.position[1 - p]};
               }));
  return made;
}

Result<PieceMotion> PieceMotion::create_of_steps(const SolverInputs& inputs, PiecesOf of) {
  PieceMotion made;
  const std::vector<Body>& bodies = inputs.model.host.bodies;
  if (inputs.air || std::any_of(bodies.begin(), bodies.end(), [](const Body& body) { return body.gas; }))
    return made;
  WEFT_TRY(any, made.create_lists(inputs, of));
  if (!any) return made;
  const State& state = inputs.state;
  const gpu::Constant joins{"kJoins", of == PiecesOf::Solids ? 1.0 : 0.0};
  WEFT_TRY(sum, gpu::create_shared_kernel(inputs.device, "method/pieces/sum_steps.wgsl", {joins},
                                          inputs.workgroup_size));
  WEFT_SET(made.sum_,
           gpu::Dispatch::create_by_parity(
               sum, sum->workgroups_of(made.lanes_), [&](std::size_t p) -> gpu::Dispatch::Bindings {
                 return {
                     state.steps,       made.lists_,       inputs.model.rest_position, state.motions,
                     state.position[p], state.velocity[p], state.position[1 - p],      *inputs.predicted()[p],
                     made.sums_};
               }));
  WEFT_TRY(move, gpu::create_shared_kernel(inputs.device, "method/pieces/move_steps.wgsl", {},
                                           inputs.workgroup_size));
  WEFT_SET(made.move_, gpu::Dispatch::create_by_parity(move, move->workgroups_of(made.lanes_),
                                                       [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                                         return {state.steps,       made.lists_,
                                                                 made.sums_,        made.turns_,
                                                                 state.position[p], *inputs.predicted()[p]};
                                                       }));
  return made;
}

void PieceMotion::record(gpu::ComputePass& pass) const {
  sum_.record(pass);
  turn_.record(pass);
  move_.record(pass);
}

}  // namespace weft
