// The pairs of a cycle's cloths that its matrix holds apart. The including kernel binds `nodes`, `pair_holds` and
// `statistics`.
#include "contact/proximity/friction.wgsl"
#include "method/multigrid/cloth.wgsl"
#include "state/pair_holds.wgsl"
#include "state/statistics.wgsl"

fn record_count() -> u32 {
  return select(min(statistics[kStatNear], arrayLength(&pair_holds)), 0u, statistics[kStatRolledBack] != 0u);
}

// Whether the pair is held, and of a cloth of this cycle; its `cloth`.
fn is_own(hold : PairHold, cloths : u32) -> bool {
  let first = hold.ids.x & kIdBits;
  if (hold.normal.w == 0.0 || first < nodes.first_vertex) { return false; }
  cloth = (first - nodes.first_vertex) / nodes.count;
  return cloth < cloths;
}
fn among_all(hold : PairHold, role : u32) -> u32 { return (hold.ids[role] & kIdBits) - nodes.first_vertex; }
fn vector_of(vector : u32, all : u32) -> u32 {
  return cloth * nodes.vectors + vector * nodes.count + (all - cloth * nodes.count);
}

// τ - k_t s, of a relative way, N.
fn reach_of(hold : PairHold, slip : f32, way : vec3f) -> vec3f {
  return hold.along.xyz - slip * part_across(way, hold.normal.xyz);
}
