// The energies of a membrane as quadratic forms of three numbers of F. The same as form.cpp in f32.
// Source: docs/elements.md, As constraints.
#include "element/membrane/law.wgsl"

struct MembraneForm {
  value : vec3f,
  warp : Axes,  // the slope of the first by F, and so on
  weft : Axes,
  shear : Axes,
}

fn form_of_strain(e : Strain) -> MembraneForm {
  return MembraneForm(e.value, Axes(e.warp, vec3f(0.0)), Axes(vec3f(0.0), e.weft), e.shear);
}

fn neo_hookean_form(f : Axes) -> MembraneForm {
  let along = length(f.warp);
  let first = f.warp / max(along, kMinStretch);
  let spanned = cross(f.warp, f.weft);
  let area = length(spanned);
  let normal = spanned / max(area, kMinStretch * kMinStretch);
  let second = cross(normal, first);
  return MembraneForm(vec3f(along - dot(f.weft, second), dot(f.weft, first), area - 1.0), Axes(first, -second),
                      Axes(second, first), Axes(cross(f.weft, normal), cross(normal, f.warp)));
}

fn membrane_form(energy : u32, f : Axes) -> MembraneForm {
  if (energy == kNeoHookean) { return neo_hookean_form(f); }
  return form_of_strain(strain_of(energy, f));
}

// What the form's numbers resist with, N/m: C11, C12, C22, C33 of a symmetric matrix.
fn form_stiffness(law : MembraneLaw) -> vec4f {
  let c = law.stiffness;
  if (law.energy == kNeoHookean) { return vec4f(c.w, 0.0, c.w, c.y + c.w); }
  return c;
}

// The axes where they are pressed as long as at rest, and no nearer to a line than 60°: form.cpp.
fn opened(f : Axes) -> Axes {
  let longer = unpressed(f);
  let a = max(length(longer.warp), kMinStretch);
  let b = max(length(longer.weft), kMinStretch);
  let n = longer.warp / a;
  let m = longer.weft / b;
  let cosine = dot(n, m);
  if (abs(cosine) <= 0.5) { return longer; }
  let turn = select(1.0, -1.0, cosine < 0.0);
  let middle = (n + turn * m) / length(n + turn * m);
  var aside = n - turn * m;
  if (length(aside) < 1e-3) {
    aside = cross(middle, select(vec3f(0.0, 1.0, 0.0), vec3f(1.0, 0.0, 0.0), abs(middle.x) < 0.6));
  }
  aside = 0.5 / length(aside) * aside;
  let along = 0.866025404 * middle;
  return Axes(a * (along + aside), turn * b * (along - aside));
}

// The slopes of the form, where those that vanish as an axis or an angle closes are as steep as they are open.
fn steep_slopes(energy : u32, f : Axes) -> MembraneForm {
  if (energy == kGreen) { return membrane_form(energy, opened(f)); }
  if (energy == kNeoHookean) { return membrane_form(energy, unpressed(f)); }
  var form = membrane_form(energy, f);
  let sine = sqrt(max(1.0 - form.value.z * form.value.z, kMinStretch));
  form.shear = Axes(form.shear.warp / sine, form.shear.weft / sine);
  return form;
}
