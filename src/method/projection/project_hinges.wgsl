// Moves the four corners of every hinge of one colour to where its moment lets them be: that of all bends before the
// sweep, and more by what it has bent since. No two hinges of a colour share a node: one invocation per hinge.
// Source: docs/solvers/xpbd.md, equations 10 to 12.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "method/fabric_params.wgsl"
#include "method/begun_hinge.wgsl"
#include "method/bent_hinge.wgsl"
#include "method/projection/color.wgsl"
override kFirst : bool = true;  // every multiplier is 0
override kKeeps : bool = true;  // whether the next sweep has them
//                                                                              elements       unit
@group(0) @binding(0)  var<uniform>             step        : StepBlock;
@group(0) @binding(1)  var<uniform>             fabric      : FabricParams;
@group(0) @binding(2)  var<uniform>             color       : ElementsOfColor;
@group(0) @binding(3)  var<storage, read>       order       : array<u32>;      // hinges, colour after colour
@group(0) @binding(4)  var<storage, read>       hinges      : array<vec4u>;    // hinges         a, b, c, d
@group(0) @binding(5)  var<storage, read>       rest_angles : array<f32>;      // hinges         rad
@group(0) @binding(6)  var<storage, read>       couplings   : array<vec2u>;    // rows of hinges and their entries
@group(0) @binding(7)  var<storage, read>       bends       : array<vec2f>;    // hinges         rad: bend_hinges.wgsl
@group(0) @binding(8)  var<storage, read>       position_in : array<vec4f>;    // vertex_count   m
@group(0) @binding(9)  var<storage, read_write> multiplier  : array<f32>;      // hinges         kg·m²
@group(0) @binding(10) var<storage, read_write> way         : array<vec4f>;    // vertex_count   m (w: 1/kg)

@compute @workgroup_size(kWorkgroupSize)
fn project_hinges(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= color.count) { return; }
  let hinge = order[color.first + index];
  let before_sweep = begun_hinge(hinge);
  let nodes = hinges[hinge];
  let a = way[nodes.x];
  let b = way[nodes.y];
  let c = way[nodes.z];
  let d = way[nodes.w];
  let bent = bent_hinge(nodes, a.xyz, b.xyz, c.xyz, d.xyz);
  let begun = bends[hinge];
  let delayed_by = fabric.law.delay / step.time.dt * bent.turned;
  let resistance = before_sweep.resistance;
  let moment = before_sweep.moment +
               resistance * (short_way((bent.angle - rest_angles[hinge]) - begun.x) + (delayed_by - begun.y));
  let at_a = -(bent.slope.b + bent.slope.c + bent.slope.d);
  let weight = dot(vec4f(a.w, b.w, c.w, d.w), vec4f(dot(at_a, at_a), dot(bent.slope.b, bent.slope.b),
                                                   dot(bent.slope.c, bent.slope.c), dot(bent.slope.d, bent.slope.d)));
  let square = step.time.dt * step.time.dt;
  var before = 0.0;
  if (!kFirst) { before = multiplier[hinge]; }
  let change = -(square * moment + before) /
               (1.0 + (square + step.time.dt * fabric.law.delay) * resistance * weight);
  if (kKeeps) { multiplier[hinge] = before + change; }
  way[nodes.x] = vec4f(a.xyz + a.w * change * at_a, a.w);
  way[nodes.y] = vec4f(b.xyz + b.w * change * bent.slope.b, b.w);
  way[nodes.z] = vec4f(c.xyz + c.w * change * bent.slope.c, c.w);
  way[nodes.w] = vec4f(d.xyz + d.w * change * bent.slope.d, d.w);
}
