// How fast the stress of a tetrahedron turns. Source: docs/solvers/xpbd.md, equation 17.
#include "element/tet/law.wgsl"

fn symmetric_part(a : mat3x3f) -> mat3x3f { return 0.5 * (a + transpose(a)); }
fn trace(a : mat3x3f) -> f32 { return a[0].x + a[1].y + a[2].z; }

// No eigenvalue of a symmetric matrix is larger: Gershgorin.
fn largest_at_most(a : mat3x3f) -> f32 {
  return max(max(a[0].x + (abs(a[0].y) + abs(a[0].z)), a[1].y + (abs(a[1].x) + abs(a[1].z))),
             a[2].z + (abs(a[2].x) + abs(a[2].y)));
}

// What damping pulls with where F was `start` a delay ago, Pa: docs/solvers/projective_dynamics.md, equation 17.
fn delayed_stress(law : SolidLaw, start : mat3x3f, f : mat3x3f, rotation : mat3x3f) -> mat3x3f {
  let begun = nearest_rotation(f * transpose(start)) * start;
  let grown = contraction(rotation, f) - contraction(nearest_rotation(start), start);
  return (2.0 * law.mu) * (f - begun) + (law.lambda * grown) * rotation;
}

// How fast a stress grows at most as F = R stretch turns, where it is R stress.
fn turning(stretch : mat3x3f, stress : mat3x3f) -> f32 {
  let pull = largest_at_most(scaled_identity(trace(stress)) - stress);
  let lever = -largest_at_most(stretch - scaled_identity(trace(stretch)));
  return max(0.0, pull) / max(1.0, lever);
}
