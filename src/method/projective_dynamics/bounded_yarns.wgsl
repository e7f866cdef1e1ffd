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

fn delayed_by(delays : f32, now : f32, before : f32) -> f32 { return now + delays * (now - before); }

// The first Piola-Kirchhoff stress, N/m, at the end of a step that began with `start` and is 1/rate s long.
fn bounded_stress(law : MembraneLaw, f : Axes, start : Axes, rate : f32) -> Axes {
  let c = law.stiffness;
  let warp = bounded_yarn(f.warp);
  let weft = bounded_yarn(f.weft);
  let warp_before = bounded_yarn(start.warp);
  let weft_before = bounded_yarn(start.weft);
  let delays = law.delay * rate;
  let sheared =
      c.w * delayed_by(delays, dot(warp.arrow, weft.arrow), dot(warp_before.arrow, weft_before.arrow));
  let along_warp = c.x * delayed_by(delays, warp.stretch - 1.0, warp_before.stretch - 1.0) +
                   c.y * delayed_by(delays, weft.coupling, weft_before.coupling) * warp.coupling_slope;
  let along_weft = c.z * delayed_by(delays, weft.stretch - 1.0, weft_before.stretch - 1.0) +
                   c.y * delayed_by(delays, warp.coupling, warp_before.coupling) * weft.coupling_slope;
  return Axes(along_warp * warp.direction + sheared * turned_arrow(warp, weft.arrow),
              along_weft * weft.direction + sheared * turned_arrow(weft, warp.arrow));
}
