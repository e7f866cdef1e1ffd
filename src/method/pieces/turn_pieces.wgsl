// How each piece whose nodes all go free has to move, as a rigid body, to have the momentum and the angular momentum
// that forces from outside give it; 0 for others. One workgroup a piece; sums run in an order that no workgroup size
// changes. Source: docs/momentum.md.
#include "gpu/index.wgsl"
#include "method/symmetric.wgsl"
#include "method/pieces/piece.wgsl"
//                                                                       elements         unit
@group(0) @binding(0) var<storage, read>       pieces : array<vec2u>;     // the first chunk, and how many
@group(0) @binding(1) var<storage, read>       sums   : array<vec4f>;     // kPieceColumns * chunks
@group(0) @binding(2) var<storage, read_write> turns  : array<vec4f>;     // kTurnColumns * pieces   m, rad
const kLanes = 64u;
var<workgroup> lanes : array<mat4x4f, kLanes>;

@compute @workgroup_size(kWorkgroupSize)
fn turn_pieces(@builtin(workgroup_id) group : vec3u, @builtin(local_invocation_index) local : u32) {
  let number = flat_group(group);
  if (number >= arrayLength(&pieces)) { return; }
  let piece = pieces[number];
  for (var lane = local; lane < kLanes; lane += kWorkgroupSize) {
    var sum = mat4x4f();
    for (var k = lane; k < piece.y; k += kLanes) {
      let at = kPieceColumns * (piece.x + k);
      sum += mat4x4f(sums[at], sums[at + 1u], sums[at + 2u], sums[at + 3u]);
    }
    lanes[lane] = sum;
  }
  workgroupBarrier();
  for (var half = kLanes / 2u; half > 0u; half /= 2u) {
    for (var lane = local; lane < half; lane += kWorkgroupSize) { lanes[lane] += lanes[lane + half]; }
    workgroupBarrier();
  }
  if (local != 0u) { return; }
  let all = lanes[0];
  let mass = all[0].w;
  let first = kTurnColumns * number;
  turns[first] = vec4f(0.0);
  turns[first + 1u] = vec4f(0.0);
  if (mass >= kHeldMass) { return; }
  let middle = all[0].xyz / mass;
  let spread = sum_of(Symmetric(all[1].xyz, vec3f(all[1].w, all[2].w, all[3].w)), outer(middle, -mass));
  let inertia = sum_of(identity(dot(spread.diagonal, vec3f(1.0))), scaled(-1.0, spread));
  let whole = -times(inverse(inertia), all[3].xyz - cross(middle, all[2].xyz));
  let turn = whole / max(1.0, length(whole));
  turns[first] = vec4f(-all[2].xyz / mass - cross(turn, middle), 0.0);
  turns[first + 1u] = vec4f(turn, 0.0);
}
