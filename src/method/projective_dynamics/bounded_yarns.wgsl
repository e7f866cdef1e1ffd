// The stress of woven cloth, cut where it would resist without bound: bounded_yarns.hpp in f32.
// Source: docs/solvers/projective_dynamics.md, Fabric.
#include "element/membrane/law.wgsl"

const kCouplesTo = 1.5;  // the stretch from which on a yarn pulls less and less at the other one
const kCouples = 0.5;    // by how much more stretch, until no more

// A yarn's direction, and what of it counts where both yarns act together.
struct BoundedYarn {
  stretch : f32,
  direction : vec3f,
  arrow : vec3f,
  coupling : f32,
  coupling_slope : f32,
  across : f32,  // of the arrow's slope
  along : f32,
}

fn bounded_yarn(f : vec3f) -> BoundedYarn {
  let stretch = length(f);
  let direction = f / max(stretch, kMinStretch);
  if (stretch < 1.0) {
    let square = stretch * stretch;
    let across = 0.5 * (3.0 - square);
    let coupling = 0.5 * (stretch - 1.0) * (stretch + 1.0);  // (s² - 1) / 2 without the rounding of s²
    return BoundedYarn(stretch, direction, across * f, coupling, stretch, across, square);
  }
  let beyond = clamp(stretch - kCouplesTo, 0.0, kCouples);
  let coupling = min(stretch, kCouplesTo) - 1.0 + (beyond - beyond * beyond / (2.0 * kCouples));
  let across = 1.0 / stretch;
  return BoundedYarn(stretch, direction, across * f, coupling, 1.0 - beyond / kCouples, across, across);
}

// (∂ arrow / ∂ F)ᵀ other
fn turned_arrow(yarn : BoundedYarn, other : vec3f) -> vec3f {
  return yarn.across * other - (yarn.along * dot(yarn.direction, other)) * yarn.direction;
}

// The first Piola-Kirchhoff stress, N/m, of what is stretched to f and changes at `rate`, 1/s.
fn bounded_stress(law : MembraneLaw, f : Axes, rate : Axes) -> Axes {
  let c = law.stiffness;
  let warp = bounded_yarn(f.warp);
  let weft = bounded_yarn(f.weft);
  let at_warp = turned_arrow(warp, weft.arrow);
  let at_weft = turned_arrow(weft, warp.arrow);
  let warp_rate = law.delay * dot(warp.direction, rate.warp);
  let weft_rate = law.delay * dot(weft.direction, rate.weft);
  let sheared =
      c.w * (dot(warp.arrow, weft.arrow) + law.delay * (dot(at_warp, rate.warp) + dot(at_weft, rate.weft)));
  let along_warp =
      c.x * (warp.stretch - 1.0 + warp_rate) + c.y * (weft.coupling * warp.coupling_slope + weft_rate);
  let along_weft =
      c.z * (weft.stretch - 1.0 + weft_rate) + c.y * (warp.coupling * weft.coupling_slope + warp_rate);
  return Axes(along_warp * warp.direction + sheared * at_warp, along_weft * weft.direction + sheared * at_weft);
}
