// The part of the pairs in A p, of the p that the search about to follow takes. Grid-stride loop over the records.
// Source: docs/solvers/multigrid.md, equations 14 and 16.
#include "gpu/index.wgsl"
#include "method/multigrid/pairs.wgsl"
#include "method/multigrid/solve.wgsl"
#include "state/add_pair_sums.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             nodes      : ClothNodes;
@group(0) @binding(1) var<storage, read>       place      : array<vec4f>;      // count           m; w: N/m, 0: fixed
@group(0) @binding(2) var<storage, read>       vectors    : array<vec4f>;      // cloth.wgsl: the finest
@group(0) @binding(3) var<storage, read>       statistics : array<u32>;
@group(0) @binding(4) var<storage, read>       pair_holds : array<PairHold>;
@group(0) @binding(5) var<storage, read_write> pair_sums  : array<atomic<u32>>;

// As in search.wgsl.
fn operand(state : Solve, all : u32) -> vec3f {
  let z = vectors[vector_of(kFirst, all)].xyz;
  return select(1.0, 0.0, state.turn == 0u) * z + state.keep * vectors[vector_of(last_search(state), all)].xyz;
}

@compute @workgroup_size(kWorkgroupSize)
fn pair_product(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u) {
  let cloths = arrayLength(&place) / nodes.count;
  let count = record_count();
  for (var number = id.x; number < count; number += groups.x * kWorkgroupSize) {
    let hold = pair_holds[number];
    if (!is_own(hold, cloths)) { continue; }
    let state = solve_state();
    if (state.done) { continue; }
    let w = weights_of(hold.ids, hold.place.x, hold.place.y);
    var way = vec3f(0.0);
    var inertia : vec4f;
    for (var role = 0u; role < 4u; role++) {
      inertia[role] = place[among_all(hold, role)].w;
      way += select(0.0, w[role], inertia[role] > 0.0) * operand(state, among_all(hold, role));
    }
    let n = hold.normal.xyz;
    let force = hold.normal.w * dot(n, way) * n + hold.along.w * part_across(way, n);
    for (var role = 0u; role < 4u; role++) {
      if (inertia[role] > 0.0) { add_pair_sum(hold.ids[role] & kIdBits, (w[role] / inertia[role]) * force); }
    }
  }
}
