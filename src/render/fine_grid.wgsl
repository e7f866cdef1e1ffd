// A finer grid through the nodes of a grid: a cubic along the rows and the columns, which goes through the nodes.
// Source: Keys, "Cubic convolution interpolation for digital image processing" (1981); in double:
// mesh/subdivided_grid.hpp.
struct FineGrid {  // mirror: src/render/fine_cloth.hpp
  first_node : u32,    // of the simulated cloth
  first_vertex : u32,  // of the drawn one
  nx : u32,            // nodes a row
  ny : u32,
  level : u32,         // how often each cell is halved
}

// Of the nodes cell - 1 to cell + 2: what the value is made of, and its derivative by the number of the node.
struct Cubic {
  cell : u32,
  weight : vec4f,
  slope : vec4f,
}

// Beyond the rim nodes go on as a parabola through three, 3 a - 3 b + c; as a line where there are 2 alone.
fn at_rim(w : vec4f, first : bool, last : bool) -> vec4f {
  if (first && last) { return vec4f(0.0, w.y + 2.0 * w.x - w.w, w.z + 2.0 * w.w - w.x, 0.0); }
  if (first) { return vec4f(0.0, w.y + 3.0 * w.x, w.z - 3.0 * w.x, w.w + w.x); }
  if (last) { return vec4f(w.x + w.w, w.y - 3.0 * w.w, w.z + 3.0 * w.w, 0.0); }
  return w;
}

// Vertex `fine` of a row through `nodes` nodes. Its place in the cell is a multiple of 1/16, so no weight is rounded.
fn cubic_at(fine : u32, nodes : u32, level : u32) -> Cubic {
  let cell = min(fine >> level, nodes - 2u);
  let t = f32(fine - (cell << level)) / f32(1u << level);
  let weight = 0.5 * vec4f(((2.0 - t) * t - 1.0) * t, (3.0 * t - 5.0) * t * t + 2.0, ((4.0 - 3.0 * t) * t + 1.0) * t,
                           (t - 1.0) * t * t);
  let slope = 0.5 * vec4f((4.0 - 3.0 * t) * t - 1.0, (9.0 * t - 10.0) * t, (8.0 - 9.0 * t) * t + 1.0,
                          (3.0 * t - 2.0) * t);
  let first = cell == 0u;
  let last = cell + 2u == nodes;
  return Cubic(cell, at_rim(weight, first, last), at_rim(slope, first, last));
}

// The node of stencil place k; where there is none the weight is 0, and any serves.
fn stencil_node(cubic : Cubic, k : u32, nodes : u32) -> u32 { return min(max(cubic.cell + k, 1u) - 1u, nodes - 1u); }
