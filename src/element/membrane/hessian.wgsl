// How the stress of a membrane triangle changes with F, without what could make that indefinite. The same as law.cpp in
// f32. Source: docs/elements.md, equations 6 to 10.
#include "element/membrane/law.wgsl"

// By the columns of F, N/m; the block (weft, warp) is `mixed` transposed.
struct MembraneHessian {
  warp : mat3x3f,
  mixed : mat3x3f,
  weft : mat3x3f,
}

fn hessian_sum(a : MembraneHessian, b : MembraneHessian) -> MembraneHessian {
  return MembraneHessian(a.warp + b.warp, a.mixed + b.mixed, a.weft + b.weft);
}
fn hessian_scaled(s : f32, a : MembraneHessian) -> MembraneHessian {
  return MembraneHessian(s * a.warp, s * a.mixed, s * a.weft);
}
fn hessian_times(h : MembraneHessian, f : Axes) -> Axes {
  return Axes(h.warp * f.warp + h.mixed * f.weft, f.warp * h.mixed + h.weft * f.weft);
}

// a bᵀ
fn dyad(a : vec3f, b : vec3f) -> mat3x3f { return mat3x3f(b.x * a, b.y * a, b.z * a); }
fn unit_matrix() -> mat3x3f { return mat3x3f(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0); }
// v -> a x v
fn cross_matrix(a : vec3f) -> mat3x3f { return mat3x3f(0.0, a.z, -a.y, -a.z, 0.0, a.x, a.y, -a.x, 0.0); }
// I - n nᵀ
fn across(n : vec3f) -> mat3x3f { return unit_matrix() - dyad(n, n); }

// Σ C_kl ∂ε_k/∂F ∂ε_l/∂F
fn material_part(c : vec4f, e : Strain) -> MembraneHessian {
  return MembraneHessian(c.x * dyad(e.warp, e.warp) + c.w * dyad(e.shear.warp, e.shear.warp),
                         c.y * dyad(e.warp, e.weft) + c.w * dyad(e.shear.warp, e.shear.weft),
                         c.z * dyad(e.weft, e.weft) + c.w * dyad(e.shear.weft, e.shear.weft));
}

// A symmetric 2 x 2 matrix xx, xy, yy without its negative principal value.
fn positive_part(s : vec3f) -> vec3f {
  let middle = 0.5 * (s.x + s.z);
  let radius = length(vec2f(0.5 * (s.x - s.z), s.y));
  if (middle - radius >= 0.0) { return s; }
  if (middle + radius <= 0.0) { return vec3f(0.0); }
  let low = middle - radius;
  return (middle + radius) / (2.0 * radius) * vec3f(s.x - low, s.y, s.z - low);
}

fn presses(s : vec3f) -> bool { return s.x < 0.0 || s.x * s.z < s.y * s.y; }

// Its principal values without their signs, and none above `most`.
fn absolute_part(s : vec3f, most : f32) -> vec3f {
  let middle = 0.5 * (s.x + s.z);
  let radius = length(vec2f(0.5 * (s.x - s.z), s.y));
  let high = min(most, abs(middle + radius));
  let low = min(most, abs(middle - radius));
  let mean = 0.5 * (high + low);
  if (radius <= 0.0) { return vec3f(mean, 0.0, mean); }
  return vec3f(mean, 0.0, mean) + (high - low) / (2.0 * radius) * vec3f(s.x - middle, s.y, s.z - middle);
}

// What holds a direction that is stressed by `now` here and `then` where a step leads: equations 7a to 9a.
fn held_axis(now : f32, then : f32, most : f32) -> f32 {
  return select(now, min(abs(then), most), min(now, then) < 0.0);
}
fn held_part(now : vec3f, then : vec3f, most : f32) -> vec3f {
  if (presses(now) || presses(then)) { return absolute_part(then, most); }
  return now;
}

fn kronecker(s : vec3f, m : mat3x3f) -> MembraneHessian { return MembraneHessian(s.x * m, s.y * m, s.z * m); }

// Yarns with this tension are held straight.
fn straightening(f : Axes, pull : vec2f) -> MembraneHessian {
  let stretch = max(vec2f(length(f.warp), length(f.weft)), vec2f(kMinStretch));
  let held = pull / stretch;
  return MembraneHessian(held.x * across(f.warp / stretch.x), mat3x3f(), held.y * across(f.weft / stretch.y));
}

fn yarn_geometry(f : Axes, s : vec3f) -> MembraneHessian { return straightening(f, max(s.xy, vec2f(0.0))); }

struct NeoHookean {
  mu : f32,
  lambda : f32,
  area : f32,      // J
  normal : vec3f,  // unit
  slope : Axes,    // of J
  s : f32,         // the energy's derivative by J
}
fn neo_hookean(c : vec4f, f : Axes) -> NeoHookean {
  let lambda = c.y + c.w;
  let spanned = cross(f.warp, f.weft);
  let area = max(length(spanned), kMinStretch * kMinStretch);
  let normal = spanned / area;
  let slope = Axes(cross(f.weft, normal), cross(normal, f.warp));
  return NeoHookean(c.w, lambda, area, normal, slope, lambda * (area - 1.0) - c.w);
}
const kLeastArea = 1e-3;  // mirror: src/element/membrane/law.cpp

// The second Piola-Kirchhoff stress, which is what resists across the plane; then that of a stress by F.
fn across_plane(n : NeoHookean, f : Axes) -> vec3f {
  let by_area = n.s / n.area;
  return vec3f(n.mu + by_area * dot(f.weft, f.weft), -by_area * dot(f.warp, f.weft),
               n.mu + by_area * dot(f.warp, f.warp));
}
fn across_plane_by(n : NeoHookean, f : Axes, stress : Axes) -> vec3f {
  let a = dot(f.warp, f.warp);
  let b = dot(f.warp, f.weft);
  let c = dot(f.weft, f.weft);
  let first = dot(f.warp, stress.warp);
  let last = dot(f.weft, stress.weft);
  let over = dot(f.warp, stress.weft);
  let under = dot(f.weft, stress.warp);
  let twice = vec3f(2.0 * (c * first - b * under), c * over - b * last + a * under - b * first,
                    2.0 * (a * last - b * over));
  let area = max(n.area, kLeastArea);
  return 0.5 / (area * area) * twice;
}
fn neo_hookean_parts(n : NeoHookean, keeps : f32, turns : f32, out : vec3f) -> MembraneHessian {
  let plane = 0.5 * (keeps + turns) * across(n.normal);
  let in_plane = MembraneHessian(plane, 0.5 * (turns - keeps) * cross_matrix(n.normal), plane);
  let warp = n.slope.warp;
  let weft = n.slope.weft;
  let by_size = hessian_scaled(n.lambda, MembraneHessian(dyad(warp, warp), dyad(warp, weft), dyad(weft, weft)));
  return hessian_sum(hessian_sum(by_size, in_plane), kronecker(out, dyad(n.normal, n.normal)));
}
fn neo_hookean_hessian(c : vec4f, f : Axes) -> MembraneHessian {
  let n = neo_hookean(c, f);
  return neo_hookean_parts(n, max(0.0, n.mu + n.s), max(0.0, n.mu - n.s), positive_part(across_plane(n, f)));
}
fn held_neo_hookean(c : vec4f, f : Axes, way : Axes) -> MembraneHessian {
  let n = neo_hookean(c, f);
  let stress = neo_hookean_stress(c, f);
  let more = hessian_times(neo_hookean_hessian(c, f), way);
  let out = across_plane_by(n, f, Axes(stress.warp + more.warp, stress.weft + more.weft));
  let then = n.s + n.lambda * (dot(n.slope.warp, way.warp) + dot(n.slope.weft, way.weft));
  let most = n.mu + n.lambda;
  return neo_hookean_parts(n, held_axis(n.mu + n.s, n.mu + then, most), max(0.0, n.mu - n.s),
                           held_part(across_plane(n, f), out, most));
}

// At the end of a step that began with `start` and is 1/rate s long: the stress, damped by how much the strain has
// changed, and how it changes with F, N/m.
struct StepStress {
  stress : Axes,
  hessian : MembraneHessian,
}
fn step_stress(law : MembraneLaw, f : Axes, start : Axes, rate : f32) -> StepStress {
  let c = law.stiffness;
  let e = strain_of(law.energy, f);
  let delays = law.delay * rate;
  let damping = delays * stress_of_strain(c, e.value - strain_of(law.energy, start).value);
  let by_strain = hessian_scaled(delays, material_part(c, e));
  if (law.energy == kNeoHookean) {
    let elastic = neo_hookean_stress(c, f);
    let damped = along(damping, e);
    let geometry = kronecker(positive_part(vec3f(damping.x, damping.z, damping.y)), unit_matrix());
    return StepStress(Axes(elastic.warp + damped.warp, elastic.weft + damped.weft),
                      hessian_sum(hessian_sum(neo_hookean_hessian(c, f), by_strain), geometry));
  }
  let s = stress_of_strain(c, e.value) + damping;
  if (law.energy == kYarn) {
    return StepStress(along(s, e), hessian_sum(hessian_sum(material_part(c, e), by_strain), yarn_geometry(f, s)));
  }
  let geometry = kronecker(positive_part(vec3f(s.x, s.z, s.y)), unit_matrix());
  return StepStress(along(s, e),
                    hessian_sum(hessian_sum(material_part(c, green_strain(unpressed(f))), by_strain), geometry));
}

fn membrane_hessian(law : MembraneLaw, f : Axes) -> MembraneHessian {
  if (law.energy == kNeoHookean) { return neo_hookean_hessian(law.stiffness, f); }
  let e = strain_of(law.energy, f);
  let s = stress_of_strain(law.stiffness, e.value);
  if (law.energy == kYarn) { return hessian_sum(material_part(law.stiffness, e), yarn_geometry(f, s)); }
  return hessian_sum(material_part(law.stiffness, green_strain(unpressed(f))),
                     kronecker(positive_part(vec3f(s.x, s.z, s.y)), unit_matrix()));
}

// That of a step that first leads F by `way`: what presses here, or by this Hessian there, resists being turned by the
// force that it has there, as if it pulled.
fn held_membrane_hessian(law : MembraneLaw, f : Axes, way : Axes) -> MembraneHessian {
  let c = law.stiffness;
  if (law.energy == kNeoHookean) { return held_neo_hookean(c, f, way); }
  let e = strain_of(law.energy, f);
  let more = vec3f(dot(e.warp, way.warp), dot(e.weft, way.weft),
                   dot(e.shear.warp, way.warp) + dot(e.shear.weft, way.weft));
  let now = stress_of_strain(c, e.value);
  let then = stress_of_strain(c, e.value + more);
  if (law.energy == kYarn) {
    let pull = vec2f(held_axis(now.x, then.x, c.x), held_axis(now.y, then.y, c.z));
    return hessian_sum(material_part(c, e), straightening(f, pull));
  }
  return hessian_sum(material_part(c, green_strain(unpressed(f))),
                     kronecker(held_part(now.xzy, then.xzy, max(c.x, c.z)), unit_matrix()));
}

// The derivative of the stress of damping by the rate of F, N·s/m.
fn damping_hessian(law : MembraneLaw, f : Axes) -> MembraneHessian {
  return hessian_scaled(law.delay, material_part(law.stiffness, strain_of(law.energy, f)));
}
