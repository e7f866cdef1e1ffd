// One substep of a grid cloth, prediction included: gathers the forces of a node's springs and integrates it. One
// invocation per node. Neighbours and rest lengths follow from the node's place, so nothing but the state is read.
// Source: docs/solvers/mass_spring.md, "node-centric". Sums run in a fixed order: the same bits every run.
#include "shared/index.wgsl"
#include "shared/integrate.wgsl"
#include "shared/spring_force.wgsl"
struct GridParams {  // mirror: src/solver/mass_spring/advance_grid.hpp
  first_vertex : u32,
  nx : u32,
  ny : u32,
  uniform_weights : u32,  // 1: springs along the boundary count in full
  stiffness : vec4f,      // N/m: structural, shear, bend
  rest_length : vec4f,    // m: structural along i, along j, shear
  damping : f32,          // N·s/m
}
//                                                                               elements            unit
@group(0) @binding(0) var<uniform>             step         : StepParams;
@group(0) @binding(1) var<uniform>             grid         : GridParams;
@group(0) @binding(2) var<storage, read>       position_in  : array<vec4f>;   // vertex_count        m (w: inverse mass, 1/kg)
@group(0) @binding(3) var<storage, read>       velocity_in  : array<vec4f>;   // vertex_count        m/s
@group(0) @binding(4) var<storage, read>       rest         : array<vec4f>;   // vertex_count        m (w: motion)
@group(0) @binding(5) var<storage, read>       motions      : array<vec4f>;   // 3 * motions * substeps
@group(0) @binding(6) var<storage, read_write> position_out : array<vec4f>;   // vertex_count        m
@group(0) @binding(7) var<storage, read_write> velocity_out : array<vec4f>;   // vertex_count        m/s

fn pull(x : vec3f, v : vec3f, neighbour : u32, rest_length : f32, stiffness : f32, weight : f32) -> vec3f {
  if (stiffness == 0.0) { return vec3f(0.0); }  // springs of no stiffness do not damp either
  let span = position_in[neighbour].xyz - x;
  var rate = vec3f(0.0);
  if (grid.damping > 0.0) { rate = velocity_in[neighbour].xyz - v; }
  let spring = spring_state(span, rate, rest_length, weight * stiffness, weight * grid.damping);
  return spring.tension * spring.direction;
}

@compute @workgroup_size(kWorkgroupSize)
fn advance_grid(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  let nx = grid.nx;
  let ny = grid.ny;
  if (index >= nx * ny) { return; }
  let node = grid.first_vertex + index;
  let before = NodeState(position_in[node], velocity_in[node]);
  if (before.position.w == 0.0) {
    let after = integrate_held(before, rest[node]);
    position_out[node] = after.position;
    velocity_out[node] = after.velocity;
    return;
  }
  if (is_grabbed(node)) {
    let after = integrate_grabbed(node, before);
    position_out[node] = after.position;
    velocity_out[node] = after.velocity;
    return;
  }
  let j = index / nx;
  let i = index - j * nx;
  let x = before.position.xyz;
  let v = before.velocity.xyz;
  let full = grid.uniform_weights == 1u;
  let along_i = select(0.5, 1.0, full || (j > 0u && j + 1u < ny));  // a boundary spring has cloth on one side only
  let along_j = select(0.5, 1.0, full || (i > 0u && i + 1u < nx));
  let rest_i = grid.rest_length.x;
  let rest_j = grid.rest_length.y;
  let rest_shear = grid.rest_length.z;
  let structural = grid.stiffness.x;
  let shear = grid.stiffness.y;
  let bend = grid.stiffness.z;

  var force = vec3f(0.0);
  if (i > 0u) { force += pull(x, v, node - 1u, rest_i, structural, along_i); }
  if (i + 1u < nx) { force += pull(x, v, node + 1u, rest_i, structural, along_i); }
  if (j > 0u) { force += pull(x, v, node - nx, rest_j, structural, along_j); }
  if (j + 1u < ny) { force += pull(x, v, node + nx, rest_j, structural, along_j); }
  if (i > 0u && j > 0u) { force += pull(x, v, node - nx - 1u, rest_shear, shear, 1.0); }
  if (i + 1u < nx && j > 0u) { force += pull(x, v, node - nx + 1u, rest_shear, shear, 1.0); }
  if (i > 0u && j + 1u < ny) { force += pull(x, v, node + nx - 1u, rest_shear, shear, 1.0); }
  if (i + 1u < nx && j + 1u < ny) { force += pull(x, v, node + nx + 1u, rest_shear, shear, 1.0); }
  if (i > 1u) { force += pull(x, v, node - 2u, 2.0 * rest_i, bend, along_i); }
  if (i + 2u < nx) { force += pull(x, v, node + 2u, 2.0 * rest_i, bend, along_i); }
  if (j > 1u) { force += pull(x, v, node - 2u * nx, 2.0 * rest_j, bend, along_j); }
  if (j + 2u < ny) { force += pull(x, v, node + 2u * nx, 2.0 * rest_j, bend, along_j); }

  let after = integrate_free(before, force);
  position_out[node] = after.position;
  velocity_out[node] = after.velocity;
}
