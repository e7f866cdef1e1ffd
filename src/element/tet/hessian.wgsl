// How the stress of a tetrahedron changes with F, without what could make that indefinite: the same as hessian.hpp in
// f32. Source: docs/bodies.md, All nodes at once.
#include "element/tet/principal.wgsl"

// F = U Σ Vᵀ by two rotations.
struct TetFrame {
  u : mat3x3f,
  v : mat3x3f,
  stretches : vec3f,
}

// ∂P/∂F in such a frame, Pa: what of the stretches acts on each; entries xy, yz, zx by themselves, then yx, zy, xz; and
// both of a pair by the other, yz, zx, xy.
struct TetHessian {
  stretch : mat3x3f,
  onward : vec3f,
  back : vec3f,
  crossed : vec3f,
}

// `rotation`: the one that is nearest to F.
fn tet_frame(f : mat3x3f, rotation : mat3x3f) -> TetFrame {
  let s = transpose(rotation) * f;
  let found = principal(0.5 * (s + transpose(s)));
  return TetFrame(rotation * found.axes, found.axes, found.values);
}

fn without_negative(symmetric : mat3x3f) -> mat3x3f {
  let found = principal(symmetric);
  let value = max(found.values, vec3f(0.0));
  let v = found.axes;
  return outer_product(value.x * v[0], v[0]) + outer_product(value.y * v[1], v[1]) +
         outer_product(value.z * v[2], v[2]);
}

// By what resists where two axes turn against each other, and where both shear; neither is negative.
fn hessian_by_axes(stretch : mat3x3f, twist : vec3f, shear : vec3f) -> TetHessian {
  let straight = 0.5 * (shear + twist);
  return TetHessian(stretch, straight.zxy, straight.zxy, 0.5 * (shear - twist));
}

fn neo_hookean_hessian(law : SolidLaw, s : vec3f) -> TetHessian {
  let bulk = law.lambda + law.mu;
  let pressure = bulk * (s.x * s.y * s.z - 1.0) - law.mu;
  let across = s.yzx * s.zxy;
  let both = bulk * (across.yzx * across.zxy) + pressure * s;
  let own = vec3f(law.mu) + bulk * (across * across);
  let stretch = mat3x3f(own.x, both.z, both.y, both.z, own.y, both.x, both.y, both.x, own.z);
  return hessian_by_axes(without_negative(stretch), max(vec3f(0.0), law.mu + pressure * s),
                         max(vec3f(0.0), law.mu - pressure * s));
}

const kLeastSum = 0.1;  // mirror: src/element/tet/hessian.cpp

fn corotated_hessian(law : SolidLaw, s : vec3f) -> TetHessian {
  let turning = law.lambda * (s.x + s.y + s.z - 3.0) - 2.0 * law.mu;
  let own = 2.0 * law.mu + law.lambda;
  let stretch = mat3x3f(own, law.lambda, law.lambda, law.lambda, own, law.lambda, law.lambda, law.lambda, own);
  let sums = max(s.yzx + s.zxy, vec3f(kLeastSum));
  return hessian_by_axes(stretch, max(vec3f(0.0), 2.0 * law.mu + 2.0 * turning / sums), vec3f(2.0 * law.mu));
}

fn tet_hessian(law : SolidLaw, frame : TetFrame) -> TetHessian {
  if (law.energy == kTetNeoHookean) { return neo_hookean_hessian(law, frame.stretches); }
  return corotated_hessian(law, frame.stretches);
}

// How the energy grows with each stretch, Pa.
fn principal_stress(law : SolidLaw, s : vec3f) -> vec3f {
  if (law.energy == kTetNeoHookean) {
    let pressure = (law.lambda + law.mu) * (s.x * s.y * s.z - 1.0) - law.mu;
    return law.mu * s + pressure * (s.yzx * s.zxy);
  }
  return 2.0 * law.mu * (s - vec3f(1.0)) + law.lambda * (s.x + s.y + s.z - 3.0);
}

// tet_hessian of a step that first leads F by `way`: where two axes are pressed, here or by `positive` there, they
// resist being turned by the stress that they have there, as if it pulled.
fn held_tet_hessian(law : SolidLaw, frame : TetFrame, positive : TetHessian, way : mat3x3f) -> TetHessian {
  let s = frame.stretches;
  let stress = principal_stress(law, s);
  let led = vec3f(dot(frame.u[0], way * frame.v[0]), dot(frame.u[1], way * frame.v[1]),
                  dot(frame.u[2], way * frame.v[2]));
  let led_stress = stress + positive.stretch * led;
  let now = stress.yzx + stress.zxy;
  let then = led_stress.yzx + led_stress.zxy;
  let twist = min(abs(then) / max(s.yzx + s.zxy, vec3f(kLeastSum)), vec3f(2.0 * law.mu + law.lambda));
  let straight = positive.onward.yzx;
  return hessian_by_axes(positive.stretch, select(straight - positive.crossed, twist, min(now, then) < vec3f(0.0)),
                         straight + positive.crossed);
}

// What damping adds by the rate of F, Pa·s.
fn tet_damping_hessian(law : SolidLaw, frame : TetFrame) -> TetHessian {
  let s = frame.stretches;
  let mu = law.delay * law.mu;
  let both = law.delay * law.lambda * outer_product(s, s);
  let own = 2.0 * mu * s * s;
  return TetHessian(both + mat3x3f(own.x, 0.0, 0.0, 0.0, own.y, 0.0, 0.0, 0.0, own.z), mu * s * s,
                    mu * s.yzx * s.yzx, mu * s.yzx * s.zxy);
}

fn tet_hessian_sum(a : TetHessian, b : TetHessian) -> TetHessian {
  return TetHessian(a.stretch + b.stretch, a.onward + b.onward, a.back + b.back, a.crossed + b.crossed);
}
fn tet_hessian_scaled(s : f32, a : TetHessian) -> TetHessian {
  return TetHessian(s * a.stretch, s * a.onward, s * a.back, s * a.crossed);
}

// P's change for one of F.
fn tet_hessian_times(frame : TetFrame, h : TetHessian, change : mat3x3f) -> mat3x3f {
  let a = transpose(frame.u) * change * frame.v;
  let d = h.stretch * vec3f(a[0].x, a[1].y, a[2].z);
  let x = vec3f(d.x, h.back.x * a[0].y + h.crossed.z * a[1].x, h.onward.z * a[0].z + h.crossed.y * a[2].x);
  let y = vec3f(h.onward.x * a[1].x + h.crossed.z * a[0].y, d.y, h.back.y * a[1].z + h.crossed.x * a[2].y);
  let z = vec3f(h.back.z * a[2].x + h.crossed.y * a[0].z, h.onward.y * a[2].y + h.crossed.x * a[1].z, d.z);
  return frame.u * mat3x3f(x, y, z) * transpose(frame.v);
}
