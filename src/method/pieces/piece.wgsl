// Pieces of cloth that may go free (free_pieces.hpp): their nodes, and sums over these. Source: docs/momentum.md.
const kPieceChunk = 64u;     // nodes of one piece; mirror: src/method/pieces/piece_motion.hpp
const kChunkWords = 4u;      // mirror: src/method/pieces/piece_motion.hpp
const kPieceColumns = 4u;    // of a chunk's sums; mirror: src/method/pieces/piece_motion.hpp
const kTurnColumns = 2u;     // of a piece's motion: the shift of its first node, and the angle
const kHeldMass = 1.0e30;    // kg: of a node that does not go free; no cloth has as much

// So many nodes of one piece: words of `lists`, which has them before the nodes, piece after piece.
struct PieceChunk {
  first : u32,       // among the nodes
  count : u32,       // at most kPieceChunk
  piece : u32,
  first_node : u32,  // of the piece: places count from it, since f32 knows those near it well
}

// Of nodes, with q their places from the first one, e how far they move beyond what forces from outside give, and t by
// how much they turn besides: columns of Σ m q and Σ m; Σ m q q, xx, yy, zz and yz; Σ m e and of xz; Σ m (q × e + t)
// and of xy.
fn held_sums() -> mat4x4f { return mat4x4f(vec4f(vec3f(0.0), kHeldMass), vec4f(0.0), vec4f(0.0), vec4f(0.0)); }
fn node_sums(mass : f32, q : vec3f, e : vec3f, t : vec3f) -> mat4x4f {
  let mixed = mass * q.yxx * q.zzy;
  return mat4x4f(vec4f(mass * q, mass), vec4f(mass * q * q, mixed.x), vec4f(mass * e, mixed.y),
                 vec4f(mass * (cross(q, e) + t), mixed.z));
}
