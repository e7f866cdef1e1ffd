// What the air resists with at a node, from the triangles around it: equations 1 and 2 of docs/air.md. The including
// kernel has a StepBlock `step`, binds `corners`, and has corner_place(vertex), m.
#include "method/corners.wgsl"
#include "method/symmetric.wgsl"
#include "state/step.wgsl"
#include "state/wind.wgsl"

// A part of a triangle, over which the air goes at `slip`, m/s. `normal` is as long as twice the area of that part, m²:
// B of the triangle's law, kg/s, positive semidefinite.
fn air_on_triangle(normal : vec3f, slip : vec3f) -> Symmetric {
  let size = length(normal);
  if (size == 0.0) { return zero_matrix(); }
  let n = normal / size;
  let across = dot(n, slip);
  let friction = step.air.friction * length(slip);
  let pressure = step.air.pressure * abs(across) + step.air.lift * length(slip - across * n);
  return scaled(0.5 * size, sum_of(outer(n, pressure - friction), identity(friction)));
}

fn air_at(vertex : u32, slip : vec3f) -> Symmetric {
  let own = corner_place(vertex);
  var sum = zero_matrix();
  for (var entry = corners[vertex]; entry < corners[vertex + 1u]; entry += 3u) {
    sum = sum_of(sum, air_on_triangle(normal_of(own, entry), slip));
  }
  return sum;
}

// No eigenvalue of air_at is above this, kg/s.
fn most_air_at(vertex : u32, slip : vec3f) -> f32 {
  let own = corner_place(vertex);
  var normals = 0.0;
  for (var entry = corners[vertex]; entry < corners[vertex + 1u]; entry += 3u) {
    normals += length(normal_of(own, entry));
  }
  return 0.5 * normals * (step.air.pressure + step.air.lift + step.air.friction) * length(slip);
}
