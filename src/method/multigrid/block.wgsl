// A 3 x 3 matrix: its symmetric part, and s of the rest, v -> s x v.
#include "method/symmetric.wgsl"

struct Block {
  symmetric : Symmetric,
  skew : vec3f,
}

// s of (M - Mᵀ) / 2, v -> s x v
fn skew_of(m : mat3x3f) -> vec3f { return 0.5 * vec3f(m[1].z - m[2].y, m[2].x - m[0].z, m[0].y - m[1].x); }

fn block_sum(a : Block, b : Block) -> Block { return Block(sum_of(a.symmetric, b.symmetric), a.skew + b.skew); }
fn block_scaled(s : f32, a : Block) -> Block { return Block(scaled(s, a.symmetric), s * a.skew); }
