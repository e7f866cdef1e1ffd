// The forces of a membrane triangle on two of its corners; the third bears the rest. The same as law.hpp in f32.
// Source: docs/elements.md, equations 1 to 5 and 10.
const kGreen = 0u;
const kYarn = 1u;
const kNeoHookean = 2u;
const kMinStretch = 1e-9;  // an axis that is shorter by this factor has no direction, and pulls nowhere

struct MembraneLaw {
  stiffness : vec4f,  // N/m: C11, C12, C22, C33
  delay : f32,        // s
  energy : u32,
}

// The columns of F, or of what multiplies them.
struct Axes {
  warp : vec3f,
  weft : vec3f,
}

struct Strain {
  value : vec3f,  // warp, weft, shear
  shear : Axes,   // slope of the shear by F
  warp : vec3f,   // slope of the warp's strain by F1
  weft : vec3f,   // slope of the weft's strain by F2
}

fn green_strain(f : Axes) -> Strain {
  let value = vec3f(0.5 * (dot(f.warp, f.warp) - 1.0), 0.5 * (dot(f.weft, f.weft) - 1.0), dot(f.warp, f.weft));
  return Strain(value, Axes(f.weft, f.warp), f.warp, f.weft);
}

fn yarn_strain(f : Axes) -> Strain {
  let stretch = max(vec2f(length(f.warp), length(f.weft)), vec2f(kMinStretch));
  let n = f.warp / stretch.x;
  let m = f.weft / stretch.y;
  let cosine = dot(n, m);
  let slope = Axes((m - cosine * n) / stretch.x, (n - cosine * m) / stretch.y);
  return Strain(vec3f(stretch - 1.0, cosine), slope, n, m);
}

// The axes where they are pressed as long as at rest: law.cpp.
fn unpressed(f : Axes) -> Axes {
  let stretch = max(vec2f(length(f.warp), length(f.weft)), vec2f(kMinStretch));
  return Axes(max(1.0, 1.0 / stretch.x) * f.warp, max(1.0, 1.0 / stretch.y) * f.weft);
}

fn stress_of_strain(c : vec4f, e : vec3f) -> vec3f {
  return vec3f(c.x * e.x + c.y * e.y, c.y * e.x + c.z * e.y, c.w * e.z);
}

fn along(s : vec3f, e : Strain) -> Axes {
  return Axes(s.x * e.warp + s.z * e.shear.warp, s.y * e.weft + s.z * e.shear.weft);
}

fn neo_hookean_stress(c : vec4f, f : Axes) -> Axes {
  let n = cross(f.warp, f.weft);
  let area = max(length(n), kMinStretch * kMinStretch);
  let normal = n / area;
  let s = (c.y + c.w) * (area - 1.0) - c.w;
  return Axes(c.w * f.warp + s * cross(f.weft, normal), c.w * f.weft + s * cross(normal, f.warp));
}

// Neo-Hookean cloth is damped by the rate of Green's strain.
fn strain_of(energy : u32, f : Axes) -> Strain {
  if (energy == kYarn) { return yarn_strain(f); }
  return green_strain(f);
}

// How fast the strain changes where F does by `rate`, times the delay.
fn delayed(law : MembraneLaw, e : Strain, rate : Axes) -> vec3f {
  let strain_rate = vec3f(dot(e.warp, rate.warp), dot(e.weft, rate.weft),
                          dot(e.shear.warp, rate.warp) + dot(e.shear.weft, rate.weft));
  return law.delay * strain_rate;
}

// What damping adds to the stress, N/m, of what is stretched to f and is changing at `rate`, 1/s.
fn damping_stress(law : MembraneLaw, f : Axes, rate : Axes) -> Axes {
  let e = strain_of(law.energy, f);
  return along(stress_of_strain(law.stiffness, delayed(law, e, rate)), e);
}

// The first Piola-Kirchhoff stress, N/m, of the same.
fn membrane_stress(law : MembraneLaw, f : Axes, rate : Axes) -> Axes {
  let e = strain_of(law.energy, f);
  let damping = delayed(law, e, rate);
  if (law.energy != kNeoHookean) { return along(stress_of_strain(law.stiffness, e.value + damping), e); }
  let elastic = neo_hookean_stress(law.stiffness, f);
  let damped = along(stress_of_strain(law.stiffness, damping), e);
  return Axes(elastic.warp + damped.warp, elastic.weft + damped.weft);
}

fn area_of(slopes : vec4f) -> f32 { return 0.5 / abs(slopes.x * slopes.w - slopes.y * slopes.z); }

// F, or its rate, of a triangle with these spans from its first corner to the others; `slopes` are those of the others'
// shape functions, 1/m: along warp and weft, of the second and of the third.
fn deformation(slopes : vec4f, second : vec3f, third : vec3f) -> Axes {
  return Axes(slopes.x * second + slopes.z * third, slopes.y * second + slopes.w * third);
}

// Of a corner's shape function along warp and weft, 1/m.
fn corner_slope(slope : vec4f, corner : u32) -> vec2f {
  if (corner == 0u) { return -(slope.xy + slope.zw); }
  return select(slope.zw, slope.xy, corner == 1u);
}

struct MembraneForces {
  second : vec3f,  // N
  third : vec3f,
}
fn membrane_forces(slopes : vec4f, stress : Axes) -> MembraneForces {
  let area = area_of(slopes);
  return MembraneForces(-area * (slopes.x * stress.warp + slopes.y * stress.weft),
                        -area * (slopes.z * stress.warp + slopes.w * stress.weft));
}
