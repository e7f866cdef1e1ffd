// Where cloth would meet cloth on the ways that the solver has predicted: how far a blow would take a vertex off its
// own way, and where. What is at rest has little slack, and what is struck would go no farther; so a search is asked
// for that knows of it. By the list of the last search, in which what comes is listed before it strikes. Grid-stride
// loop over the pairs.
// Source: docs/contact.md, Reach.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/meeting.wgsl"
#include "contact/proximity/reach.wgsl"
#include "contact/proximity/separation.wgsl"
#include "contact/proximity/sums.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read>       previous        : array<vec4f>; // vertex_count      m; w: 1/kg
@group(0) @binding(2) var<storage, read>       position        : array<vec4f>; // vertex_count      m, where it comes
@group(0) @binding(3) var<storage, read>       predicted       : array<vec4f>; // 3 * vertex_count  m: reach.wgsl
@group(0) @binding(4) var<storage, read>       points          : array<vec4f>; // of colliders: move_points.wgsl
@group(0) @binding(5) var<storage, read>       listed          : array<ListedPair>;
@group(0) @binding(6) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(7) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(8) var<storage, read_write> statistics      : array<atomic<u32>>;

var<workgroup> pairs : u32;

fn slack_of(id : u32) -> f32 { return predicted[step.nodes.count + (id & kIdBits)].w; }

// How far a vertex comes off its way, as it goes on, if it is moved aside at its end, m.
fn off_the_way(id : u32, aside : vec3f) -> f32 {
  let way = place_of(id) - before_of(id);
  return distance_from_way(Reach(vec3f(0.0), 0.0, kReachMargin * way), way + aside);
}

fn expect_blow(ids : vec4u, sides : u32, thickness : f32) {
  let measured = measure(ids, sides);
  let n = measured.normal;
  let along = ends_along(ids, n);
  let ends = Ends(measured.gap > 0.0, n, 0.0, measured.gap, thickness, along, sides_apart(ids, along));
  let push = clamp(kPushPart * (thickness - measured.gap), 0.0, kPushSpeed * step.time.dt);  // equation (5a)
  var shifts = select(vec4f(-push), vec4f(push), vec4<bool>(true, is_edge_pair(ids), false, false));
  if (end_too_near(ids, ends)) { shifts += shifts_of(ids, along, measured.gap, movers_by_whole_mass(ids)); }
  for (var role = 0u; role < 4u; role++) {
    let needed = kReachMargin * off_the_way(ids[role], shifts[role] * n);
    if (needed <= slack_of(ids[role])) { continue; }
    let at = kVertexWords * (ids[role] & kIdBits);
    atomicMax(&vertex_contacts[at + kBlowWord], bitcast<u32>(needed));
    add_units(at + kChangeWord, kSpeedUnits, sign(shifts[role]) * n);
    atomicStore(&statistics[kStatDetect], 1u);
  }
}

@compute @workgroup_size(kWorkgroupSize)
fn expect_blows(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u,
                @builtin(local_invocation_index) thread : u32) {
  if (thread == 0u) {
    let idle = atomicLoad(&statistics[kStatRolledBack]) != 0u;
    pairs = select(atomicLoad(&statistics[kStatPairs]), 0u, idle);
  }
  let count = workgroupUniformLoad(&pairs);
  for (var pair = id.x; pair < count; pair += groups.x * kWorkgroupSize) {
    let ids = listed[pair].ids;
    if (is_crossing(ids) || !is_self_pair(ids)) { continue; }
    let words = listed[pair].words;
    let before = gap_of(words);  // in the last substep; and the distance that they keep
    let slack = min(min(slack_of(ids.x), slack_of(ids.y)), min(slack_of(ids.z), slack_of(ids.w)));
    // No vertex is moved farther than both sides go and a push.
    let push = select(0.0, kPushSpeed * step.time.dt, before.x < before.y);
    if (before.y <= 0.0 || kReachMargin * (2.0 * longest_way(ids) + push) <= slack) { continue; }
    expect_blow(ids, words.w, before.y);
  }
}
