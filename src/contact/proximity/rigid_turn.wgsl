// Rotations of rigid bodies. Source: docs/rigid.md, equation (2).

fn product(a : vec4f, b : vec4f) -> vec4f {
  return vec4f(a.w * b.xyz + b.w * a.xyz + cross(a.xyz, b.xyz), a.w * b.w - dot(a.xyz, b.xyz));
}
fn conjugate(q : vec4f) -> vec4f { return vec4f(-q.xyz, q.w); }
fn rotated(q : vec4f, v : vec3f) -> vec3f {
  let t = 2.0 * cross(q.xyz, v);
  return v + q.w * t + cross(q.xyz, t);
}
fn unit_of(q : vec4f) -> vec4f { return q / sqrt(dot(q, q)); }

// Sine over x, and cosine, for |x| up to 2: Taylor's series, to 1e-7; no built-in one, whose bits differ by the device.
fn sine_over(x : f32) -> f32 {
  let s = x * x;
  return 1.0 - s / 6.0 * (1.0 - s / 20.0 * (1.0 - s / 42.0 * (1.0 - s / 72.0 * (1.0 - s / 110.0))));
}
fn cosine_of(x : f32) -> f32 {
  let s = x * x;
  return 1.0 - s / 2.0 * (1.0 - s / 12.0 * (1.0 - s / 30.0 * (1.0 - s / 56.0 * (1.0 - s / 90.0 * (1.0 - s / 132.0)))));
}
const kMostHalfTurn = 2.0;  // rad, of a part of a substep's rotation

// Turned about a vector of the world by its length, rad.
fn turned_by(q : vec4f, angle : vec3f) -> vec4f {
  let half = min(0.5 * length(angle), kMostHalfTurn);
  return unit_of(product(vec4f(0.5 * sine_over(half) * angle, cosine_of(half)), q));
}
fn turned_about_own(q : vec4f, axis : u32, angle : f32) -> vec4f {
  let half = clamp(0.5 * angle, -kMostHalfTurn, kMostHalfTurn);
  var own = vec4f(0.0, 0.0, 0.0, cosine_of(half));
  own[axis] = half * sine_over(half);
  return unit_of(product(q, own));
}
fn along_own(q : vec4f, axis : u32, momentum : vec3f) -> f32 { return rotated(conjugate(q), momentum)[axis]; }

// How a body turns in a step that nothing touches.
fn turned_freely(inertia : vec3f, turn : vec4f, momentum : vec3f, step : f32) -> vec4f {
  var a = 0u;
  var b = 1u;
  var c = 2u;
  if (inertia[a] > inertia[b]) { let t = a; a = b; b = t; }
  if (inertia[b] > inertia[c]) { let t = b; b = c; c = t; }
  if (inertia[a] > inertia[b]) { let t = a; a = b; b = t; }
  let middle = b;
  let less = 1.0 / inertia[a] - 1.0 / inertia[middle];
  let more = 1.0 / inertia[c] - 1.0 / inertia[middle];
  var q = turned_by(turn, step / inertia[middle] * momentum);
  q = turned_about_own(q, a, 0.5 * step * less * along_own(q, a, momentum));
  q = turned_about_own(q, c, step * more * along_own(q, c, momentum));
  return turned_about_own(q, a, 0.5 * step * less * along_own(q, a, momentum));
}

// R I⁻¹ Rᵀ v.
fn spin_of(inertia : vec3f, turn : vec4f, momentum : vec3f) -> vec3f {
  return rotated(turn, rotated(conjugate(turn), momentum) / inertia);
}
