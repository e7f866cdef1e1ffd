// The springs of one node of a grid. The including file defines the node's data, Own, and a spring's contribution to
// the sum, pull(own, other, number, rest_length, longest, weight, stiffness, damping): `other` is the place of the
// spring's other end, `number` which of the springs of its first end it is, `longest` the length beyond which it is
// stiffer, 0: none, `weight` the part of stiffness and damping that counts.
#include "element/spring/spring_grid.wgsl"

// The sum over the springs of node (i, j), which is at place `at`; a row is `row` places long. The order is fixed:
// the same bits on every run.
fn sum_of_springs(own : Own, grid : SpringGrid, at : u32, row : u32, i : u32, j : u32) -> vec3f {
  let nx = grid.nx;
  let ny = grid.ny;
  let along_i = line_weight(grid, j, ny);
  let along_j = line_weight(grid, i, nx);
  let length0 = grid.rest_length;
  let k = grid.stiffness;
  let c = grid.damping;
  var sum = vec3f(0.0);
  if (i > 0u) { sum += pull(own, at - 1u, kRight, length0.x, grid.longest.x, along_i, k.x, c.x); }
  if (i + 1u < nx) { sum += pull(own, at + 1u, kRight, length0.x, grid.longest.x, along_i, k.x, c.x); }
  if (j > 0u) { sum += pull(own, at - row, kDown, length0.y, grid.longest.y, along_j, k.x, c.x); }
  if (j + 1u < ny) { sum += pull(own, at + row, kDown, length0.y, grid.longest.y, along_j, k.x, c.x); }
  if (i > 0u && j > 0u) { sum += pull(own, at - row - 1u, kDownRight, length0.z, 0.0, 1.0, k.y, c.y); }
  if (i + 1u < nx && j > 0u) { sum += pull(own, at - row + 1u, kDownLeft, length0.z, 0.0, 1.0, k.y, c.y); }
  if (i > 0u && j + 1u < ny) { sum += pull(own, at + row - 1u, kDownLeft, length0.z, 0.0, 1.0, k.y, c.y); }
  if (i + 1u < nx && j + 1u < ny) { sum += pull(own, at + row + 1u, kDownRight, length0.z, 0.0, 1.0, k.y, c.y); }
  if (kBend) {
    if (i > 1u) { sum += pull(own, at - 2u, kFarRight, 2.0 * length0.x, 0.0, along_i, k.z, c.z); }
    if (i + 2u < nx) { sum += pull(own, at + 2u, kFarRight, 2.0 * length0.x, 0.0, along_i, k.z, c.z); }
    if (j > 1u) { sum += pull(own, at - 2u * row, kFarDown, 2.0 * length0.y, 0.0, along_j, k.z, c.z); }
    if (j + 2u < ny) { sum += pull(own, at + 2u * row, kFarDown, 2.0 * length0.y, 0.0, along_j, k.z, c.z); }
  }
  return sum;
}
