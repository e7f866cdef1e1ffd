// From one level of a grid to the next, P and Pᵀ: coarse node I coincides with fine node 2 I, the last with the last;
// fine nodes between take the mean. A side that is not halved stays as it is.
// Source: docs/solvers/multigrid.md, equation 7.
#include "method/multigrid/grid_level.wgsl"

// How much fine node `fine` takes from coarse node `coarse`, along a side of n fine and m coarse nodes.
fn tap(fine : i32, coarse : i32, n : i32, m : i32) -> f32 {
  let apart = abs(fine - min(2 * coarse, n - 1));
  let beside = select(0.0, 0.5, (apart == 1) & ((fine & 1) == 1) & (fine + 1 != n));
  let halved = select(beside, 1.0, apart == 0);
  let kept = select(0.0, 1.0, fine == coarse);
  return select(0.0, select(halved, kept, n == m), (coarse >= 0) & (coarse < m));
}

// The weights of it in fine nodes at `center` - 1, `center` and `center` + 1; 0 where there is no such node.
fn taps_about(center : i32, coarse : i32, n : i32, m : i32) -> vec3f {
  return vec3f(inside_tap(center - 1, coarse, n, m), inside_tap(center, coarse, n, m),
               inside_tap(center + 1, coarse, n, m));
}
fn inside_tap(fine : i32, coarse : i32, n : i32, m : i32) -> f32 {
  return select(0.0, tap(fine, coarse, n, m), fine >= 0 && fine < n);
}

// The fine node on which a coarse one lies.
fn center_of(coarse : u32, n : u32, m : u32) -> u32 { return select(min(2u * coarse, n - 1u), coarse, n == m); }
