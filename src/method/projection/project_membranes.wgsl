// Moves the corners of every triangle of one colour to where its strains' compliance and damping let them be. No two
// triangles of a colour share a node: one invocation per triangle. Source: docs/solvers/xpbd.md, equations 8 and 9.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "method/fabric_params.wgsl"
#include "element/membrane/form.wgsl"
#include "method/projection/color.wgsl"
override kFirst : bool = true;       // every multiplier is 0
override kKeeps : bool = true;  // whether the next sweep has them
override kDampedApart : bool = false;  // by strains that are not the energy's: a second block, behind the first
//                                                                              elements       unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<uniform>             fabric      : FabricParams;
@group(0) @binding(2) var<uniform>             color       : ElementsOfColor;
@group(0) @binding(3) var<storage, read>       order       : array<u32>;      // triangles, colour after colour
@group(0) @binding(4) var<storage, read>       corners     : array<u32>;      // 3 * triangles
@group(0) @binding(5) var<storage, read>       slopes      : array<vec4f>;    // triangles      1/m: membrane/build.hpp
@group(0) @binding(6) var<storage, read>       position_in : array<vec4f>;    // vertex_count   m
@group(0) @binding(7) var<storage, read_write> multiplier  : array<f32>;      // 3 or 6 * triangles  kg·m²
@group(0) @binding(8) var<storage, read_write> way         : array<vec4f>;    // vertex_count   m (w: 1/kg)

struct Corners {
  rest : vec4f,    // slopes of the second and third corner's shape functions, 1/m
  second : vec3f,  // from the first to the others at the start of the substep, m
  third : vec3f,
  way_a : vec4f,
  way_b : vec4f,
  way_c : vec4f,
}

// Ways are short: their differences keep digits that those of places have lost.
fn moved(at : Corners) -> Axes {
  return deformation(at.rest, at.way_b.xyz - at.way_a.xyz, at.way_c.xyz - at.way_a.xyz);
}
fn deformed(at : Corners) -> Axes {
  return deformation(at.rest, at.second + (at.way_b.xyz - at.way_a.xyz), at.third + (at.way_c.xyz - at.way_a.xyz));
}

fn along_axes(a : Axes, f : Axes) -> f32 { return dot(a.warp, f.warp) + dot(a.weft, f.weft); }

// The corners' parts of a slope by F, 1/m.
struct CornerSlopes {
  a : vec3f,
  b : vec3f,
  c : vec3f,
}
fn at_corners(rest : vec4f, slope : Axes) -> CornerSlopes {
  let b = rest.x * slope.warp + rest.y * slope.weft;
  let c = rest.z * slope.warp + rest.w * slope.weft;
  return CornerSlopes(-(b + c), b, c);
}
fn weighed(w : vec3f, p : CornerSlopes, q : CornerSlopes) -> f32 {
  return dot(w, vec3f(dot(p.a, q.a), dot(p.b, q.b), dot(p.c, q.c)));
}

// A symmetric 3 x 3 matrix by its columns from the diagonal down, xx xy xz and yy yz zz, solved by L D Lᵀ: exact to
// rounding however unlike the rows are.
fn solve_symmetric(column : vec3f, rest : vec3f, right : vec3f) -> vec3f {
  let l = column.yz / column.x;
  let yy = rest.x - l.x * column.y;
  let yz = rest.y - l.x * column.z;
  let m = yz / yy;
  let zz = rest.z - l.y * column.z - m * yz;
  let y = right.y - l.x * right.x;
  let z = (right.z - l.y * right.x - m * y) / zz;
  let middle = y / yy - m * z;
  return vec3f(right.x / column.x - l.x * middle - l.y * z, middle, z);
}

// Projects one block of three constraints, whose multipliers begin at `entry`. `elastic` is h² and `damping` h τ, s².
fn project(at : Corners, form : MembraneForm, steep : MembraneForm, k : vec4f, elastic : f32, damping : f32,
           entry : u32) -> Corners {
  let area = area_of(at.rest);
  let scale = 1.0 / (area * (k.x * k.z - k.y * k.y));
  let compliance = vec3f(scale * k.z, -scale * k.y, scale * k.x);
  let shear_compliance = 1.0 / (area * k.w);
  var before = vec3f(0.0);
  if (!kFirst) { before = vec3f(multiplier[entry], multiplier[entry + 1u], multiplier[entry + 2u]); }
  let change = moved(at);
  let turned = vec3f(along_axes(form.warp, change), along_axes(form.weft, change), along_axes(form.shear, change));
  let held = vec3f(compliance.x * before.x + compliance.y * before.y,
                   compliance.y * before.x + compliance.z * before.y, shear_compliance * before.z);
  let left = elastic * form.value + damping * turned + held;
  let w = vec3f(at.way_a.w, at.way_b.w, at.way_c.w);
  let p = at_corners(at.rest, steep.warp);
  let q = at_corners(at.rest, steep.weft);
  let r = at_corners(at.rest, steep.shear);
  let s = elastic + damping;
  let column = vec3f(compliance.x + s * weighed(w, p, p), compliance.y + s * weighed(w, p, q), s * weighed(w, p, r));
  let rest = vec3f(compliance.z + s * weighed(w, q, q), s * weighed(w, q, r), shear_compliance + s * weighed(w, r, r));
  let found = -solve_symmetric(column, rest, left);
  if (kKeeps) {
    multiplier[entry] = before.x + found.x;
    multiplier[entry + 1u] = before.y + found.y;
    multiplier[entry + 2u] = before.z + found.z;
  }
  let push = at_corners(at.rest, Axes(
      found.x * form.warp.warp + found.y * form.weft.warp + found.z * form.shear.warp,
      found.x * form.warp.weft + found.y * form.weft.weft + found.z * form.shear.weft));
  return Corners(at.rest, at.second, at.third, vec4f(at.way_a.xyz + w.x * push.a, w.x),
                 vec4f(at.way_b.xyz + w.y * push.b, w.y), vec4f(at.way_c.xyz + w.z * push.c, w.z));
}

@compute @workgroup_size(kWorkgroupSize)
fn project_membranes(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= color.count) { return; }
  let triangle = order[color.first + index];
  let a = corners[3u * triangle];
  let b = corners[3u * triangle + 1u];
  let c = corners[3u * triangle + 2u];
  let x = position_in[a].xyz;
  var at = Corners(slopes[triangle], position_in[b].xyz - x, position_in[c].xyz - x, way[a], way[b], way[c]);
  let square = step.time.dt * step.time.dt;
  let delayed_by = step.time.dt * fabric.law.delay;
  let f = deformed(at);
  let energy = fabric.law.energy;
  at = project(at, membrane_form(energy, f), steep_slopes(energy, f), form_stiffness(fabric.law), square,
               select(delayed_by, 0.0, kDampedApart), 3u * triangle);
  if (kDampedApart) {
    let then = deformed(at);
    at = project(at, membrane_form(kGreen, then), steep_slopes(kGreen, then), fabric.law.stiffness, 0.0, delayed_by,
                 3u * (fabric.triangles + triangle));
  }
  way[a] = at.way_a;
  way[b] = at.way_b;
  way[c] = at.way_c;
}
