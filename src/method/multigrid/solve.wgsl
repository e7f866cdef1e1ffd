// The state of a substep's conjugate gradients, in the last elements of `vectors`, cloth by cloth from the end: so
// every kernel of the cycle sees, without another binding, whether there is something left to do. The including kernel
// binds `vectors`. Source: docs/solvers/multigrid.md, equations 13 to 15.
const kSolveWords = 3u;  // mirror: src/method/multigrid/cycle.hpp

struct Solve {
  first : f32,   // norm of the first system's residual at its start, squared
  left : f32,    // the same now
  enough : f32,  // the same of a solved system
  rho : f32,     // r·z, of the guess r·p
  rate : f32,    // how far it goes along p
  keep : f32,    // the part of the last p in p
  turn : u32,    // iterations of both systems, and one more for the guess
  done : bool,
  begun : u32,   // the turn with which the second system has begun
}

fn solve_at() -> u32 { return arrayLength(&vectors) - kSolveWords * (cloth + 1u); }
fn is_solved() -> bool { return vectors[solve_at() + 1u].w != 0.0; }
fn solve_state() -> Solve {
  let at = solve_at();
  let a = vectors[at];
  let b = vectors[at + 1u];
  return Solve(a.x, a.y, a.z, a.w, b.x, b.y, u32(b.z), b.w != 0.0, u32(vectors[at + 2u].x));
}

// Where p of the last iteration is, and where that of this one goes.
fn last_search(state : Solve) -> u32 { return kSearch + (state.turn & 1u); }
fn this_search(state : Solve) -> u32 { return kSearch + 1u - (state.turn & 1u); }
