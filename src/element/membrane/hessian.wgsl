// How the stress of a membrane triangle changes with F, and without what could make that indefinite. The same as
// law.cpp in f32. Source: docs/elements.md, equations 6 to 10.
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

// The axes where they are pressed as long as at rest: law.cpp.
fn unpressed(f : Axes) -> Axes {
  let stretch = max(vec2f(length(f.warp), length(f.weft)), vec2f(kMinStretch));
  return Axes(max(1.0, 1.0 / stretch.x) * f.warp, max(1.0, 1.0 / stretch.y) * f.weft);
}

fn green_geometry(s : vec3f, clamped : bool) -> MembraneHessian {
  var second = vec3f(s.x, s.z, s.y);
  if (clamped) { second = positive_part(second); }
  return kronecker(second, unit_matrix());
}

// How the slope of the cosine changes by an axis: equation 6.
fn cosine_curvature(n : vec3f, other : vec3f, stretch : f32) -> mat3x3f {
  let cosine = dot(n, other);
  let slope = other - cosine * n;
  return -1.0 / (stretch * stretch) * (dyad(n, slope) + dyad(slope, n) + cosine * across(n));
}

fn yarn_geometry(f : Axes, s : vec3f, clamped : bool) -> MembraneHessian {
  let stretch = max(vec2f(length(f.warp), length(f.weft)), vec2f(kMinStretch));
  let n = f.warp / stretch.x;
  let m = f.weft / stretch.y;
  let pull = select(s.xy, max(s.xy, vec2f(0.0)), clamped) / stretch;
  var geometry = MembraneHessian(pull.x * across(n), mat3x3f(), pull.y * across(m));
  if (!clamped) {
    let curvature = MembraneHessian(cosine_curvature(n, m, stretch.x),
                                    1.0 / (stretch.x * stretch.y) * (across(n) * across(m)),
                                    cosine_curvature(m, n, stretch.y));
    geometry = hessian_sum(geometry, hessian_scaled(s.z, curvature));
  }
  return geometry;
}

fn neo_hookean_hessian(c : vec4f, f : Axes, clamped : bool) -> MembraneHessian {
  let lambda = c.y + c.w;
  let spanned = cross(f.warp, f.weft);
  let area = max(length(spanned), kMinStretch * kMinStretch);
  let normal = spanned / area;
  let warp = cross(f.weft, normal);
  let weft = cross(normal, f.warp);
  let s = lambda * (area - 1.0) - c.w;
  let by_area = s / area;
  var out = vec3f(c.w + by_area * dot(f.weft, f.weft), -by_area * dot(f.warp, f.weft),
                  c.w + by_area * dot(f.warp, f.warp));
  var keeps = c.w + s;
  var turns = c.w - s;
  if (clamped) {
    out = positive_part(out);
    keeps = max(0.0, keeps);
    turns = max(0.0, turns);
  }
  let plane = 0.5 * (keeps + turns) * across(normal);
  let in_plane = MembraneHessian(plane, 0.5 * (turns - keeps) * cross_matrix(normal), plane);
  let by_size = hessian_scaled(lambda, MembraneHessian(dyad(warp, warp), dyad(warp, weft), dyad(weft, weft)));
  return hessian_sum(hessian_sum(by_size, in_plane), kronecker(out, dyad(normal, normal)));
}

// Clamped: what is never indefinite.
fn membrane_hessian(law : MembraneLaw, f : Axes, clamped : bool) -> MembraneHessian {
  if (law.energy == kNeoHookean) { return neo_hookean_hessian(law.stiffness, f, clamped); }
  let e = strain_of(law.energy, f);
  let s = stress_of_strain(law.stiffness, e.value);
  if (law.energy == kYarn) { return hessian_sum(material_part(law.stiffness, e), yarn_geometry(f, s, clamped)); }
  var known = f;
  if (clamped) { known = unpressed(f); }
  return hessian_sum(material_part(law.stiffness, green_strain(known)), green_geometry(s, clamped));
}

// The derivative of the stress of damping by the rate of F, N·s/m.
fn damping_hessian(law : MembraneLaw, f : Axes) -> MembraneHessian {
  return hessian_scaled(law.delay, material_part(law.stiffness, strain_of(law.energy, f)));
}
