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

fn kronecker(s : vec3f, m : mat3x3f) -> MembraneHessian { return MembraneHessian(s.x * m, s.y * m, s.z * m); }

fn yarn_geometry(f : Axes, s : vec3f) -> MembraneHessian {
  let stretch = max(vec2f(length(f.warp), length(f.weft)), vec2f(kMinStretch));
  let pull = max(s.xy, vec2f(0.0)) / stretch;
  return MembraneHessian(pull.x * across(f.warp / stretch.x), mat3x3f(), pull.y * across(f.weft / stretch.y));
}

fn neo_hookean_hessian(c : vec4f, f : Axes) -> MembraneHessian {
  let lambda = c.y + c.w;
  let spanned = cross(f.warp, f.weft);
  let area = max(length(spanned), kMinStretch * kMinStretch);
  let normal = spanned / area;
  let warp = cross(f.weft, normal);
  let weft = cross(normal, f.warp);
  let s = lambda * (area - 1.0) - c.w;
  let by_area = s / area;
  let out = positive_part(vec3f(c.w + by_area * dot(f.weft, f.weft), -by_area * dot(f.warp, f.weft),
                                c.w + by_area * dot(f.warp, f.warp)));
  let keeps = max(0.0, c.w + s);
  let turns = max(0.0, c.w - s);
  let plane = 0.5 * (keeps + turns) * across(normal);
  let in_plane = MembraneHessian(plane, 0.5 * (turns - keeps) * cross_matrix(normal), plane);
  let by_size = hessian_scaled(lambda, MembraneHessian(dyad(warp, warp), dyad(warp, weft), dyad(weft, weft)));
  return hessian_sum(hessian_sum(by_size, in_plane), kronecker(out, dyad(normal, normal)));
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

// The derivative of the stress of damping by the rate of F, N·s/m.
fn damping_hessian(law : MembraneLaw, f : Axes) -> MembraneHessian {
  return hessian_scaled(law.delay, material_part(law.stiffness, strain_of(law.energy, f)));
}
