// Moves the two nodes of every spring of one colour to where the spring's compliance and damping let them be. No two
// springs of a colour share a node, so each invocation has its nodes for itself: one invocation per spring.
// Source: docs/solvers/xpbd.md, equations 3 to 5.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "element/spring/law.wgsl"
#include "element/spring/packed_spring.wgsl"
#include "method/projection/color.wgsl"
override kFirst : bool = true;  // every multiplier is 0
override kKeeps : bool = true;  // whether the next sweep has them
//                                                                              elements       unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<uniform>             color       : ElementsOfColor;
@group(0) @binding(2) var<storage, read>       springs     : array<Spring>;      // colour after colour
@group(0) @binding(3) var<storage, read>       kinds       : array<SpringKind>;
@group(0) @binding(4) var<storage, read>       position_in : array<vec4f>;       // vertex_count   m
@group(0) @binding(5) var<storage, read_write> multiplier  : array<f32>;         // as springs     kg·m
@group(0) @binding(6) var<storage, read_write> way         : array<vec4f>;       // vertex_count   m (w: 1/kg)

@compute @workgroup_size(kWorkgroupSize)
fn project_springs(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= color.count) { return; }
  let at = color.first + index;
  let s = springs[at];
  let node_b = s.node_b_and_kind & ((1u << kSpringNodeBits) - 1u);
  let kind = kinds[s.node_b_and_kind >> kSpringNodeBits];
  let way_a = way[s.node_a];
  let way_b = way[node_b];
  // Ways are short: their difference keeps digits that the difference of places has lost.
  let turn = way_b.xyz - way_a.xyz;
  let span = (position_in[node_b].xyz - position_in[s.node_a].xyz) + turn;
  let spring = spring_state(span, turn / step.time.dt, s.rest_length, kind.stiffness, kind.damping);
  var before = 0.0;
  if (!kFirst) { before = multiplier[at]; }
  let square = step.time.dt * step.time.dt;
  let resistance = (square * kind.stiffness + step.time.dt * kind.damping) * (way_a.w + way_b.w);
  let change = -(square * spring.tension + before) / (1.0 + resistance);
  if (kKeeps) { multiplier[at] = before + change; }
  let push = (change * spring.per_length) * span;
  way[s.node_a] = vec4f(way_a.xyz - way_a.w * push, way_a.w);
  way[node_b] = vec4f(way_b.xyz + way_b.w * push, way_b.w);
}
