// Two substeps of a grid cloth in one dispatch, where a dispatch costs more than the step: the same bits as two of
// advance_grid. One workgroup per tile of 16 x 8 nodes. It reads the tile and four nodes around it, advances the tile
// and two nodes around it, and from those the tile: halo nodes are advanced more than once, with the same bits.
// Source: docs/solvers/mass_spring.md, "Two steps at once".
#include "method/mass_spring/grid_force.wgsl"
#include "state/integrate.wgsl"
//                                                                               elements            unit
@group(0) @binding(0) var<uniform>             steps        : array<StepBlock, 2>;
@group(0) @binding(1) var<uniform>             grid         : SpringGrid;
@group(0) @binding(2) var<storage, read>       position_in  : array<vec4f>;   // vertex_count        m (w: 1/kg)
@group(0) @binding(3) var<storage, read>       velocity_in  : array<vec4f>;   // vertex_count        m/s
@group(0) @binding(4) var<storage, read>       rest         : array<vec4f>;   // vertex_count        m (w: motion)
@group(0) @binding(5) var<storage, read>       motions      : array<vec4f>;   // 3 * motions * substeps
@group(0) @binding(6) var<storage, read_write> position_out : array<vec4f>;   // vertex_count        m
@group(0) @binding(7) var<storage, read_write> velocity_out : array<vec4f>;   // vertex_count        m/s

const kTileWidth = 16u;   // kTileWidth in src/method/mass_spring/advance_grid_twice.cpp
const kTileHeight = 8u;
const kRim = 4u;          // nodes around the tile: springs reach two nodes, twice
const kRow = kTileWidth + 2u * kRim;
const kPlaces = kRow * (kTileHeight + 2u * kRim);
const kInvocations = 256u;  // as many as have a node in the first substep, and 16 more

var<private> step : StepBlock;
var<private> cloth : u32;  // of equal ones, along z
// 28 bytes per node: 10.5 of the 16 KiB that every adapter has.
var<workgroup> tile_position : array<vec4f, kPlaces>;
var<workgroup> tile_velocity_x : array<f32, kPlaces>;
var<workgroup> tile_velocity_y : array<f32, kPlaces>;
var<workgroup> tile_velocity_z : array<f32, kPlaces>;

fn position_at(place : u32) -> vec3f { return tile_position[place].xyz; }
fn velocity_at(place : u32) -> vec3f {
  return vec3f(tile_velocity_x[place], tile_velocity_y[place], tile_velocity_z[place]);
}
fn put(place : u32, state : NodeState) {
  tile_position[place] = state.position;
  tile_velocity_x[place] = state.velocity.x;
  tile_velocity_y[place] = state.velocity.y;
  tile_velocity_z[place] = state.velocity.z;
}

// A node of the grid, and its place in the tile.
struct Site {
  there : bool,  // the grid goes that far
  place : u32,
  i : u32,
  j : u32,
  node : u32,
}
// The site that is the `index`th of those at least `inset` nodes from the rim's edge.
fn site_of(tile : vec2u, index : u32, inset : u32) -> Site {
  let width = kRow - 2u * inset;
  let local_j = index / width + inset;
  let local_i = index % width + inset;
  let i = i32(tile.x * kTileWidth + local_i) - i32(kRim);
  let j = i32(tile.y * kTileHeight + local_j) - i32(kRim);
  let inside = local_j < kTileHeight + 2u * kRim - inset;
  let there = inside && i >= 0 && j >= 0 && i < i32(grid.nx) && j < i32(grid.ny);
  let node = grid.first_vertex + (cloth * grid.ny + u32(j)) * grid.nx + u32(i);
  return Site(there, local_j * kRow + local_i, u32(i), u32(j), node);
}

fn advance(site : Site) -> NodeState {
  let before = NodeState(tile_position[site.place], vec4f(velocity_at(site.place), 0.0));
  let own = Own(before.position.xyz, before.velocity.xyz);
  return integrate_node(site.node, before, grid_force(own, site.place, kRow, site.i, site.j));
}

@compute @workgroup_size(kInvocations)
fn advance_grid_twice(@builtin(workgroup_id) group : vec3u, @builtin(local_invocation_index) local : u32) {
  let tile = group.xy;
  cloth = group.z;
  for (var index = local; index < kPlaces; index += kInvocations) {
    let site = site_of(tile, index, 0u);
    if (site.there) { put(site.place, NodeState(position_in[site.node], velocity_in[site.node])); }
  }
  workgroupBarrier();

  step = steps[0];
  let wide = site_of(tile, local, 2u);
  var after : NodeState;
  if (wide.there) { after = advance(wide); }
  workgroupBarrier();
  if (wide.there) { put(wide.place, after); }
  workgroupBarrier();

  step = steps[1];
  let site = site_of(tile, local, kRim);
  if (site.there) {
    let last = advance(site);
    position_out[site.node] = last.position;
    velocity_out[site.node] = last.velocity;
  }
}
