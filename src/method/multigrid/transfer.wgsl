// From one level to the next: coarse node I lies on fine node 2 I, the last on the last; fine nodes between take the mean.
// A side that is not halved stays as it is.
#include "method/multigrid/level.wgsl"

// How much fine node `fine` takes from coarse node `coarse`, along a side of n fine and m coarse nodes.
fn tap(fine : i32, coarse : i32, n : i32, m : i32) -> f32 {
  if (coarse < 0 || coarse >= m) { return 0.0; }
  if (n == m) { return select(0.0, 1.0, fine == coarse); }
  let apart = abs(fine - min(2 * coarse, n - 1));
  if (apart == 0) { return 1.0; }
  return select(0.0, 0.5, apart == 1 && (fine & 1) == 1 && fine + 1 != n);
}

// What fine nodes at `center` - 1, `center` and `center` + 1 take from it; 0 where there is no such node.
fn taps_about(center : i32, coarse : i32, n : i32, m : i32) -> vec3f {
  return vec3f(inside_tap(center - 1, coarse, n, m), inside_tap(center, coarse, n, m), inside_tap(center + 1, coarse, n, m));
}
fn inside_tap(fine : i32, coarse : i32, n : i32, m : i32) -> f32 { return select(0.0, tap(fine, coarse, n, m), fine >= 0 && fine < n); }

// The fine node on which a coarse one lies.
fn center_of(coarse : u32, n : u32, m : u32) -> u32 { return select(min(2u * coarse, n - 1u), coarse, n == m); }

// The coarse nodes that a fine one takes from, the same twice where it is one.
fn taps_of(fine : u32, n : u32, m : u32) -> vec2u {
  if (n == m) { return vec2u(fine); }
  if (fine + 1u == n) { return vec2u(m - 1u); }
  return vec2u(fine / 2u, (fine + 1u) / 2u);
}
