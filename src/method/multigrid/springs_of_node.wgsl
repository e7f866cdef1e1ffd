// The springs of a node of a grid. The including file says what one adds: pull(neighbour, rest_length, stiffness, damping).
#include "method/multigrid/spring_grid.wgsl"

fn structural(grid : SpringGrid, neighbour : u32, rest_length : f32, weight : f32) -> vec3f {
  if (grid.stiffness.x == 0.0) { return vec3f(0.0); }  // springs of no stiffness do not damp either
  return pull(neighbour, rest_length, weight * grid.stiffness.x, weight * grid.damping);
}
fn shear(grid : SpringGrid, neighbour : u32) -> vec3f {
  if (grid.stiffness.y == 0.0) { return vec3f(0.0); }
  return pull(neighbour, grid.rest_length.z, grid.stiffness.y, grid.damping);
}
fn bend(grid : SpringGrid, neighbour : u32, rest_length : f32, weight : f32) -> vec3f {
  if (grid.stiffness.z == 0.0) { return vec3f(0.0); }
  return pull(neighbour, 2.0 * rest_length, weight * grid.stiffness.z, weight * grid.damping);
}

// The sum of pull over a node's springs, in a fixed order.
fn sum_of_springs(grid : SpringGrid, i : u32, j : u32, node : u32) -> vec3f {
  let nx = grid.nx;
  let ny = grid.ny;
  let along_i = line_weight(grid, j, ny);
  let along_j = line_weight(grid, i, nx);
  let rest_i = grid.rest_length.x;
  let rest_j = grid.rest_length.y;
  var sum = vec3f(0.0);
  if (i > 0u) { sum += structural(grid, node - 1u, rest_i, along_i); }
  if (i + 1u < nx) { sum += structural(grid, node + 1u, rest_i, along_i); }
  if (j > 0u) { sum += structural(grid, node - nx, rest_j, along_j); }
  if (j + 1u < ny) { sum += structural(grid, node + nx, rest_j, along_j); }
  if (i > 0u && j > 0u) { sum += shear(grid, node - nx - 1u); }
  if (i + 1u < nx && j > 0u) { sum += shear(grid, node - nx + 1u); }
  if (i > 0u && j + 1u < ny) { sum += shear(grid, node + nx - 1u); }
  if (i + 1u < nx && j + 1u < ny) { sum += shear(grid, node + nx + 1u); }
  if (i > 1u) { sum += bend(grid, node - 2u, rest_i, along_i); }
  if (i + 2u < nx) { sum += bend(grid, node + 2u, rest_i, along_i); }
  if (j > 1u) { sum += bend(grid, node - 2u * nx, rest_j, along_j); }
  if (j + 2u < ny) { sum += bend(grid, node + 2u * nx, rest_j, along_j); }
  return sum;
}
