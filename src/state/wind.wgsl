// The wind at a place: equations 8 and 9 of docs/solvers/mass_spring.md. Nothing but + - *, floor and abs, and no sum
// left to the compiler: these round the same on every driver, which dot, fract and sin need not do.
#include "state/step.wgsl"

// A parabola up and one down: period 1, height 1, within 0.06 of -sin(2 pi phase).
fn wave(phase : f32) -> f32 {
  let u = 2.0 * (phase - floor(phase)) - 1.0;
  return 4.0 * u * (1.0 - abs(u));
}

fn wind_wave(form : vec4f, x : vec3f) -> f32 {
  return wave(form.x * x.x + form.y * x.y + form.z * x.z - form.w);
}

// A select: for a branch on a uniform lavapipe would compile the kernel again at each bind (docs/architecture.md).
fn wind_at(x : vec3f) -> vec3f {
  let wind = step.air.wind.xyz + wind_wave(step.air.wind_wave_a, x) * step.air.gust_a.xyz +
             wind_wave(step.air.wind_wave_b, x) * step.air.gust_b.xyz;
  return select(vec3f(0.0), wind, step.air.wind.w != 0.0);
}
