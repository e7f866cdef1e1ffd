// The part of a membrane in the matrix, by the columns of F and times its area: kTermWords words a triangle. The
// including kernel binds `terms`.
#include "method/multigrid/block.wgsl"
const kTermWords = 6u;  // mirror: src/method/multigrid/fabric_system.cpp

struct MembraneTerm {
  warp : Symmetric,
  weft : Symmetric,
  mixed : Block,
}

fn term_of(triangle : u32) -> MembraneTerm {
  let first = kTermWords * triangle;
  let a = terms[first];
  let b = terms[first + 1u];
  let c = terms[first + 2u];
  let d = terms[first + 3u];
  let e = terms[first + 4u];
  let f = terms[first + 5u];
  return MembraneTerm(Symmetric(a.xyz, vec3f(a.w, b.xy)), Symmetric(vec3f(b.zw, c.x), c.yzw),
                      Block(Symmetric(d.xyz, vec3f(d.w, e.xy)), vec3f(e.zw, f.x)));
}

// What it is for two corners, by the slopes of their shape functions along warp and weft.
fn block_of_term(term : MembraneTerm, row : vec2f, column : vec2f) -> Block {
  let straight = sum_of(scaled(row.x * column.x, term.warp), scaled(row.y * column.y, term.weft));
  let across = row.x * column.y + row.y * column.x;
  return Block(sum_of(straight, scaled(across, term.mixed.symmetric)),
               (row.x * column.y - row.y * column.x) * term.mixed.skew);
}
