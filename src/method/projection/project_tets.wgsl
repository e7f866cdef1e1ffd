// Moves the corners of every tetrahedron of one colour to where its energy and damping let them be. No two tetrahedra
// of a colour share a node: one invocation per tetrahedron. Source: docs/solvers/xpbd.md, Bodies.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "element/tet/principal.wgsl"
#include "method/solid_params.wgsl"
#include "method/tet_turning.wgsl"
#include "method/projection/color.wgsl"
override kFirst : bool = true;  // every multiplier is 0
override kKeeps : bool = true;  // whether the next sweep has them
override kNeoHookean : bool = true;  // the body's energy, and whether it is damped: where branches depend on uniforms,
override kDamped : bool = true;      // lavapipe compiles the kernel again for each colour
//                                                                              elements       unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<uniform>             solid       : SolidParams;
@group(0) @binding(2) var<uniform>             color       : ElementsOfColor;
@group(0) @binding(3) var<storage, read>       order       : array<u32>;      // tets, colour after colour
@group(0) @binding(4) var<storage, read>       corners     : array<vec4u>;    // tets
@group(0) @binding(5) var<storage, read>       rests       : array<vec4f>;    // 3 * tets       1/m, m³
@group(0) @binding(6) var<storage, read>       position_in : array<vec4f>;    // vertex_count   m
@group(0) @binding(7) var<storage, read_write> multiplier  : array<f32>;      // 9 * tets       kg·m², columns
@group(0) @binding(8) var<storage, read_write> way         : array<vec4f>;    // vertex_count   m (w: 1/kg)

// What bounds how fast h² V times the stress, in the frame of the rotation that is nearest to F, grows with a change X
// of F in that frame: strain (X + Xᵀ)/2 + turn (X - Xᵀ)/2 + Σ along c (c : X), kg·m².
struct Bound {
  strain : f32,
  turn : f32,
  along : vec2f,
  first : mat3x3f,  // c
  second : mat3x3f,
}

// Not less than what n: |F|², J: det F make of second derivatives of s J by F, s = -1 or 1: the largest root of
// t³ - n t - 2 s J, by Newton's method from above.
fn most_of_volume(square : f32, signed_volume : f32) -> f32 {
  let n = square + 1e-12;  // so that F = 0 has one
  var t = sqrt(4.0 / 3.0 * n);
  for (var k = 0; k < 4; k++) { t -= (t * (t * t - n) - 2.0 * signed_volume) / (3.0 * t * t - n); }
  return t;
}

// Of the energy by F = R stretch, Pa.
fn bound_of(law : SolidLaw, stretch : mat3x3f) -> Bound {
  if (!kNeoHookean) {
    return Bound(2.0 * law.mu, 0.0, vec2f(law.lambda, 0.0), scaled_identity(1.0), scaled_identity(1.0));
  }
  let c = cofactor(stretch);
  let volume = dot(stretch[0], c[0]);
  let slope = (law.lambda + law.mu) * (volume - 1.0) - law.mu;  // of the energy by J
  let most = most_of_volume(contraction(stretch, stretch), select(volume, -volume, slope < 0.0));
  return Bound(law.mu + abs(slope) * most, 0.0, vec2f(law.lambda + law.mu, 0.0), c, scaled_identity(1.0));
}

// The entries ij and ji of X + B (X diag(s)) = Y, without what B does along its directions.
fn softened_pair(bound : Bound, s : vec2f, y : vec2f) -> vec2f {
  let own = 0.5 * (bound.strain + bound.turn);
  let other = 0.5 * (bound.strain - bound.turn);
  let determinant = 1.0 + own * (s.x + s.y) + bound.strain * bound.turn * s.x * s.y;
  return ((1.0 + own * s) * y - other * s * y.yx) / determinant;
}

// X of X + B (X diag(s)) = Y, without what B does along its directions.
fn softened(bound : Bound, s : vec3f, y : mat3x3f) -> mat3x3f {
  let diagonal = vec3f(y[0].x, y[1].y, y[2].z) / (1.0 + bound.strain * s);
  let xy = softened_pair(bound, s.xy, vec2f(y[1].x, y[0].y));
  let xz = softened_pair(bound, s.xz, vec2f(y[2].x, y[0].z));
  let yz = softened_pair(bound, s.yz, vec2f(y[2].y, y[1].z));
  return mat3x3f(diagonal.x, xy.y, xz.y, xy.x, diagonal.y, yz.y, xz.x, yz.x, diagonal.z);
}

// c : X diag(s)
fn weighed(c : mat3x3f, s : vec3f, x : mat3x3f) -> f32 {
  return dot(s, vec3f(dot(c[0], x[0]), dot(c[1], x[1]), dot(c[2], x[2])));
}

// X of X + B (X diag(s)) = Y.
fn solved(bound : Bound, s : vec3f, y : mat3x3f) -> mat3x3f {
  let alone = softened(bound, s, y);
  let first = softened(bound, s, bound.first);
  let second = softened(bound, s, bound.second);
  let own = vec2f(weighed(bound.first, s, first), weighed(bound.second, s, second));
  let mixed = weighed(bound.first, s, second);
  let d = 1.0 + bound.along * own;
  let right = bound.along * vec2f(weighed(bound.first, s, alone), weighed(bound.second, s, alone));
  let determinant = d.x * d.y - bound.along.x * bound.along.y * mixed * mixed;
  let taken = (d.yx * right - mixed * bound.along * right.yx) / determinant;
  return alone - taken.x * first - taken.y * second;
}

@compute @workgroup_size(kWorkgroupSize)
fn project_tets(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= color.count) { return; }
  let tet = order[color.first + index];
  let nodes = corners[tet];
  let rest = rest_of_tet(tet);
  var law = solid.law;
  law.energy = select(kTetNeoHookean + 1u, kTetNeoHookean, kNeoHookean);
  let slope_a = tet_slope(rest, 0u);
  let a = way[nodes.x];
  let b = way[nodes.y];
  let c = way[nodes.z];
  let d = way[nodes.w];
  let x = position_in[nodes.x].xyz;
  let start = tet_deformation(rest, position_in[nodes.y].xyz - x, position_in[nodes.z].xyz - x,
                              position_in[nodes.w].xyz - x);
  let change = tet_deformation(rest, b.xyz - a.xyz, c.xyz - a.xyz, d.xyz - a.xyz);
  let f = start + change;
  let rotation = nearest_rotation(f);
  let back = transpose(rotation);
  let stretch = symmetric_part(back * f);
  let elastic = step.time.dt * step.time.dt * rest.volume;
  let damping = step.time.dt * law.delay * rest.volume;
  var pull = back * (elastic * tet_stress(law, f, rotation));
  if (kDamped) { pull += damping * (back * delayed_stress(law, start, f, rotation)); }

  var bound = bound_of(law, stretch);
  bound.strain = elastic * bound.strain + damping * 2.0 * law.mu;
  bound.along = vec2f(elastic * bound.along.x, damping * law.lambda);
  bound.turn = turning(stretch, symmetric_part(pull));

  let weights = principal(outer_product(slope_a, a.w * slope_a) + outer_product(rest.b, b.w * rest.b) +
                          outer_product(rest.c, c.w * rest.c) + outer_product(rest.d, d.w * rest.d));
  let axes = weights.axes;
  let within = transpose(axes);
  bound.first = within * bound.first * axes;
  bound.second = within * bound.second * axes;
  var before = mat3x3f(vec3f(0.0), vec3f(0.0), vec3f(0.0));
  let entry = 9u * tet;
  if (!kFirst) {
    before = mat3x3f(multiplier[entry], multiplier[entry + 1u], multiplier[entry + 2u], multiplier[entry + 3u],
                     multiplier[entry + 4u], multiplier[entry + 5u], multiplier[entry + 6u], multiplier[entry + 7u],
                     multiplier[entry + 8u]);
  }
  let found = solved(bound, weights.values, within * (back * before + pull) * axes);
  let pulled = rotation * (axes * found * within);
  if (kKeeps) {
    let after = before - pulled;
    for (var k = 0u; k < 3u; k++) {
      multiplier[entry + 3u * k] = after[k].x;
      multiplier[entry + 3u * k + 1u] = after[k].y;
      multiplier[entry + 3u * k + 2u] = after[k].z;
    }
  }
  way[nodes.x] = vec4f(a.xyz - a.w * (pulled * slope_a), a.w);
  way[nodes.y] = vec4f(b.xyz - b.w * (pulled * rest.b), b.w);
  way[nodes.z] = vec4f(c.xyz - c.w * (pulled * rest.c), c.w);
  way[nodes.w] = vec4f(d.xyz - d.w * (pulled * rest.d), d.w);
}
