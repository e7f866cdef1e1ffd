// What holds each pair apart, and its part of the residual. Grid-stride loop over the records.
// Source: docs/solvers/multigrid.md, equation 16.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "method/multigrid/hold_law.wgsl"
#include "method/multigrid/pairs.wgsl"
#include "state/add_pair_sums.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             step       : StepBlock;
@group(0) @binding(1) var<uniform>             nodes      : ClothNodes;
@group(0) @binding(2) var<storage, read>       place      : array<vec4f>;      // count           m; w: N/m, 0: fixed
@group(0) @binding(3) var<storage, read>       vectors    : array<vec4f>;      // cloth.wgsl: the finest
@group(0) @binding(4) var<storage, read>       position   : array<vec4f>;      // vertex_count    m; w: 1/kg
@group(0) @binding(5) var<storage, read>       statistics : array<u32>;
@group(0) @binding(6) var<storage, read_write> pair_holds : array<PairHold>;
@group(0) @binding(7) var<storage, read_write> pair_sums  : array<atomic<u32>>;
@group(0) @binding(8) var<storage, read>       velocity   : array<vec4f>;      // vertex_count    m/s
override kAgain : bool = false;  // true: of the second system
override kBody : bool = false;   // true: of bodies with volume

// n·D⁻¹n, m/N.
fn along_inverse(all : u32, n : vec3f) -> f32 {
  let a = vectors[vector_of(kInverse, all)];
  let b = vectors[vector_of(kInverse + 1u, all)].xy;
  return dot(a.xyz, n * n) + 2.0 * (a.w * n.y * n.z + b.x * n.x * n.z + b.y * n.x * n.y);
}

// Of the sides of a pair of bodies, by their compliances: that of the stiffer one, but no more than so much stiffer
// than the softer one, each the geometric mean of both, N/m. One that does not move has none.
const kMostStiffer = 10.0;
fn stiffness_of(side : vec2f) -> f32 { return select(0.0, 1.0 / sqrt(side.x * side.y), side.x > 0.0); }
fn stiffness_of_bodies(sides : mat2x2f) -> f32 {
  let a = stiffness_of(sides[0]);
  let b = stiffness_of(sides[1]);
  return select(max(a, b), min(max(a, b), kMostStiffer * min(a, b)), min(a, b) > 0.0);
}

fn completed(given : PairHold) -> PairHold {
  var hold = given;
  let n = hold.normal.xyz;
  let w = weights_of(hold.ids, hold.place.x, hold.place.y);
  var start = vec3f(0.0);
  var ahead = vec3f(0.0);  // Σ w Δt v, m
  var pull = vec3f(0.0);  // Σ w R / a, m
  var compliance = 0.0;   // m/N
  var mobility = 0.0;     // 1/kg
  var local = 0.0;        // m/N, with all neighbours fixed
  var of_sides : mat2x2f;  // both, of either side
  for (var role = 0u; role < 4u; role++) {
    let all = among_all(hold, role);
    let vertex = hold.ids[role] & kIdBits;
    let at = place[all];
    let way = vectors[vector_of(kWay, all)].xyz;
    start += w[role] * way;
    ahead += w[role] * select(step.time.dt * velocity[vertex].xyz, way, at.w == 0.0);
    if (at.w == 0.0) { continue; }
    pull += (w[role] / at.w) * vectors[vector_of(kResidual, all)].xyz;
    let shares = abs(w[role]) * f32(atomicLoad(&pair_sums[kSumWords * vertex])) / kHeldUnits;
    compliance += shares / at.w;
    local += shares * along_inverse(all, n);
    if (kBody) { of_sides[select(0u, 1u, w[role] < 0.0)] += shares * vec2f(1.0 / at.w, along_inverse(all, n)); }
    mobility += shares * position[vertex].w;
  }
  let kept = hold.along.xyz;
  let normal = max(0.0, dot(n, kept));
  let along = select(vec3f(0.0), no_longer(part_across(kept, n), hold.force.w * normal), normal > 0.0);
  let missing = hold.place.w;
  let room = min(missing, kHoldPart * missing);
  let gap = max(room, 0.0);
  let part = select(1.0, min(1.0, kHoldRate * step.time.dt / kHoldPart), normal > 0.0);
  let restored = min(part * gap, kHoldSpeed * step.time.dt);
  let wanted = room - (gap - restored);
  let lack = wanted - dot(n, start);
  hold.normal.w = 0.0;
  // What bears has its load in the force that it bore.
  let closer = select(-dot(n, pull), compliance * normal, normal > 0.0);
  if (compliance == 0.0 || lack + closer <= 0.0) { return hold; }
  let thickness = given.start.w;
  let gap_before = thickness - missing;
  let closes = gap_before + dot(n, start) < kCloses * min(gap_before, thickness);
  // The compliance of what hangs together lies between that of its masses and that with all neighbours fixed.
  hold.normal.w = kPairStiffness / select(compliance, sqrt(local * compliance), kAgain && closes);
  if (kBody) { hold.normal.w = kPairStiffness * stiffness_of_bodies(of_sides); }
  hold.along = vec4f(along, 1.0 / compliance);
  hold.force = vec4f(normal, lack, restored, hold.force.w);
  hold.place = vec4f(given.place.xy, mobility, 1.0 / compliance);
  hold.start = vec4f(start, wanted - dot(n, ahead));
  return hold;
}

@compute @workgroup_size(kWorkgroupSize)
fn pair_force(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u) {
  let cloths = arrayLength(&place) / nodes.count;
  let count = record_count();
  for (var number = id.x; number < count; number += groups.x * kWorkgroupSize) {
    let given = pair_holds[number];
    if (!is_own(given, cloths)) { continue; }
    var hold = completed(given);
    if (hold.normal.w == 0.0) {
      pair_holds[number].normal.w = 0.0;
      continue;
    }
    let tried = reach_of(hold, hold.along.w, hold.start.xyz);
    let most = hold.force.w * hold.force.x;
    let sticks = length(tried) <= most;
    let force = (hold.force.x + hold.normal.w * hold.force.y) * hold.normal.xyz + no_longer(tried, most);
    if (!sticks) { hold.along.w = 0.0; }
    pair_holds[number] = hold;
    let w = weights_of(hold.ids, hold.place.x, hold.place.y);
    for (var role = 0u; role < 4u; role++) {
      let inertia = place[among_all(hold, role)].w;
      if (inertia > 0.0) { add_pair_sum(hold.ids[role] & kIdBits, (w[role] / inertia) * force); }
    }
  }
}
