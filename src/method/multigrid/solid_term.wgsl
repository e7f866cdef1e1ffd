// The part of a tetrahedron in the matrix: the frame of its Hessian, the slopes of its last three corners in that, 1/m,
// and the Hessian times its volume. kTetTermWords words a tetrahedron. The including kernel binds `terms`.
#include "element/tet/hessian.wgsl"
#include "method/multigrid/block.wgsl"
const kTetTermWords = 9u;  // mirror: src/method/multigrid/solid_system.cpp

struct TetTerm {
  u : mat3x3f,
  b : vec3f,
  c : vec3f,
  d : vec3f,
  hessian : TetHessian,
}

fn tet_term_of(tet : u32) -> TetTerm {
  let first = kTetTermWords * tet;
  let x = terms[first];
  let y = terms[first + 1u];
  let z = terms[first + 2u];
  let b = terms[first + 3u];
  let c = terms[first + 4u];
  let d = terms[first + 5u];
  let onward = terms[first + 6u];
  let back = terms[first + 7u];
  let stretch = mat3x3f(x.w, d.w, c.w, d.w, y.w, b.w, c.w, b.w, z.w);
  return TetTerm(mat3x3f(x.xyz, y.xyz, z.xyz), b.xyz, c.xyz, d.xyz,
                 TetHessian(stretch, onward.xyz, back.xyz, vec3f(onward.w, back.w, terms[first + 8u].x)));
}

fn slope_in_frame(term : TetTerm, corner : u32) -> vec3f {
  if (corner == 0u) { return -(term.b + term.c + term.d); }
  if (corner == 1u) { return term.b; }
  return select(term.d, term.c, corner == 2u);
}

// What it is for two corners.
fn block_of_tet(term : TetTerm, row : u32, column : u32) -> Block {
  let h = term.hessian;
  let b = slope_in_frame(term, row);
  let a = slope_in_frame(term, column);
  let both = a * b;
  let along = vec3f(h.onward.x * both.y + h.back.z * both.z, h.onward.y * both.z + h.back.x * both.x,
                    h.onward.z * both.x + h.back.y * both.y);
  let s = h.stretch;
  let k = h.crossed;
  let inside = mat3x3f(
      vec3f(s[0].x * both.x + along.x, s[0].y * b.y * a.x + k.z * b.x * a.y, s[0].z * b.z * a.x + k.y * b.x * a.z),
      vec3f(s[1].x * b.x * a.y + k.z * b.y * a.x, s[1].y * both.y + along.y, s[1].z * b.z * a.y + k.x * b.y * a.z),
      vec3f(s[2].x * b.x * a.z + k.y * b.z * a.x, s[2].y * b.y * a.z + k.x * b.z * a.y, s[2].z * both.z + along.z));
  let made = term.u * inside * transpose(term.u);
  return Block(symmetric_of(made), skew_of(made));
}
