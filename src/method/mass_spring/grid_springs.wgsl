// The springs of a node of a grid: neighbours and rest lengths follow from its place. The including kernel binds `grid`
// and says what stands at a place: position_at and velocity_at, where a row is `row` places long.
#include "element/spring/law.wgsl"
struct GridParams {  // mirror: src/method/mass_spring/grid_params.hpp
  first_vertex : u32,
  nx : u32,
  ny : u32,
  uniform_weights : u32,  // 1: springs along the boundary count in full
  stiffness : vec4f,      // N/m: structural, shear, bend
  damping : vec4f,        // N·s/m: the same; 0 where the stiffness is 0
  rest_length : vec4f,    // m: structural along i, along j, shear
  bending : vec2f,        // N/m: along i, along j
  tile_width : u32,       // nodes of a workgroup along i; a power of two
  tiles_x : u32,          // workgroups beside each other
}
override kDamped : bool = true;  // false: no spring damps, and velocities of neighbours are not read
override kBend : bool = true;    // false: there are no bend springs
override kBending : bool = false;  // whether there is resistance to bending

fn pull(x : vec3f, v : vec3f, other : u32, rest_length : f32, stiffness : f32, damping : f32) -> vec3f {
  let span = position_at(other) - x;
  var rate = vec3f(0.0);
  if (kDamped) { rate = velocity_at(other) - v; }
  let spring = spring_state(span, rate, rest_length, stiffness, damping);
  return (spring.tension * spring.per_length) * span;
}

// The second differences c(m-1) - 2 c(m) + c(m+1) around node m of a line of n, where c(m) = x(m-1) - 2 x(m) + x(m+1) is
// there for inner nodes only: what the energy k/2 c² of each takes its gradient from. Differences to x first, which are
// exact where the nodes are near.
fn bending_pull(x : vec3f, at : u32, step : u32, m : u32, n : u32) -> vec3f {
  var sum = vec3f(0.0);
  if (m > 1u) { sum += (position_at(at - 2u * step) - x) - 2.0 * (position_at(at - step) - x); }
  if (m > 0u && m + 1u < n) { sum -= 2.0 * ((position_at(at - step) - x) + (position_at(at + step) - x)); }
  if (m + 2u < n) { sum += (position_at(at + 2u * step) - x) - 2.0 * (position_at(at + step) - x); }
  return -sum;
}

// The sum runs in one order, the same bits every run. `at` is the place of node (i, j).
fn grid_force(x : vec3f, v : vec3f, at : u32, row : u32, i : u32, j : u32) -> vec3f {
  let nx = grid.nx;
  let ny = grid.ny;
  let full = grid.uniform_weights == 1u;
  let along_i = select(0.5, 1.0, full || (j > 0u && j + 1u < ny));  // a boundary spring has cloth on one side only
  let along_j = select(0.5, 1.0, full || (i > 0u && i + 1u < nx));
  let length0 = grid.rest_length;
  let k = grid.stiffness;
  let c = grid.damping;
  var force = vec3f(0.0);
  if (i > 0u) { force += pull(x, v, at - 1u, length0.x, along_i * k.x, along_i * c.x); }
  if (i + 1u < nx) { force += pull(x, v, at + 1u, length0.x, along_i * k.x, along_i * c.x); }
  if (j > 0u) { force += pull(x, v, at - row, length0.y, along_j * k.x, along_j * c.x); }
  if (j + 1u < ny) { force += pull(x, v, at + row, length0.y, along_j * k.x, along_j * c.x); }
  if (i > 0u && j > 0u) { force += pull(x, v, at - row - 1u, length0.z, k.y, c.y); }
  if (i + 1u < nx && j > 0u) { force += pull(x, v, at - row + 1u, length0.z, k.y, c.y); }
  if (i > 0u && j + 1u < ny) { force += pull(x, v, at + row - 1u, length0.z, k.y, c.y); }
  if (i + 1u < nx && j + 1u < ny) { force += pull(x, v, at + row + 1u, length0.z, k.y, c.y); }
  if (kBend) {
    if (i > 1u) { force += pull(x, v, at - 2u, 2.0 * length0.x, along_i * k.z, along_i * c.z); }
    if (i + 2u < nx) { force += pull(x, v, at + 2u, 2.0 * length0.x, along_i * k.z, along_i * c.z); }
    if (j > 1u) { force += pull(x, v, at - 2u * row, 2.0 * length0.y, along_j * k.z, along_j * c.z); }
    if (j + 2u < ny) { force += pull(x, v, at + 2u * row, 2.0 * length0.y, along_j * k.z, along_j * c.z); }
  }
  if (kBending) {
    force += (along_i * grid.bending.x) * bending_pull(x, at, 1u, i, nx);
    force += (along_j * grid.bending.y) * bending_pull(x, at, row, j, ny);
  }
  return force;
}
