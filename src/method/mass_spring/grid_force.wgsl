// The force on a node of a grid. The including kernel binds `grid` and defines the node at a place: position_at and
// velocity_at.
#include "element/spring/law.wgsl"
#include "element/spring/springs_of_node.wgsl"
override kDamped : bool = true;    // false: no spring damps, and velocities of neighbours are not read
override kBending : bool = false;  // whether there is resistance to bending

struct Own {
  x : vec3f,  // m
  v : vec3f,  // m/s
}

fn pull(own : Own, other : u32, number : u32, rest_length : f32, longest : f32, weight : f32, stiffness : f32,
        damping : f32) -> vec3f {
  let span = position_at(other) - own.x;
  var rate = vec3f(0.0);
  if (kDamped) { rate = velocity_at(other) - own.v; }
  let spring = spring_state(span, rate, rest_length, weight * stiffness, weight * damping);
  return (spring.tension * spring.per_length) * span;
}

// The second differences c(m-1) - 2 c(m) + c(m+1) around node m of a line of n, where c(m) = x(m-1) - 2 x(m) + x(m+1)
// is there for inner nodes only: what the energy k/2 c² of each takes its gradient from. Differences to x first, which
// are exact where the nodes are near.
fn bending_pull(x : vec3f, at : u32, step : u32, m : u32, n : u32) -> vec3f {
  var sum = vec3f(0.0);
  if (m > 1u) { sum += (position_at(at - 2u * step) - x) - 2.0 * (position_at(at - step) - x); }
  if (m > 0u && m + 1u < n) { sum -= 2.0 * ((position_at(at - step) - x) + (position_at(at + step) - x)); }
  if (m + 2u < n) { sum += (position_at(at + 2u * step) - x) - 2.0 * (position_at(at + step) - x); }
  return -sum;
}

// Of node (i, j), which is at place `at`; a row is `row` places long.
fn grid_force(own : Own, at : u32, row : u32, i : u32, j : u32) -> vec3f {
  var force = sum_of_springs(own, grid, at, row, i, j);
  if (kBending) {
    force += (line_weight(grid, j, grid.ny) * grid.bending.x) * bending_pull(own.x, at, 1u, i, grid.nx);
    force += (line_weight(grid, i, grid.nx) * grid.bending.y) * bending_pull(own.x, at, row, j, grid.ny);
  }
  return force;
}
