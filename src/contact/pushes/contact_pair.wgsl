// Adds the push of an intersecting pair to the three nodes of its cloth triangle. WGSL has no f32 atomics, so pushes
// are fixed point at push_scale units per metre (src/contact/pushes/push_scale.hpp); integer sums do not depend on
// thread order. The including kernel binds step, predicted, previous, cloth_triangles, object_triangles, object_ids,
// pushes, statistics.
#include "state/step.wgsl"
#include "state/hash_pair.wgsl"
#include "state/statistics.wgsl"
#include "contact/pushes/triangle_pair.wgsl"

// Mirror: ObjectTriangle in src/contact/pushes/object_triangles.hpp.
struct ObjectTriangle {
  a : vec4f,  // m; the three w are the outward unit normal, rounded from double on the host: no kernel divides
  b : vec4f,
  c : vec4f,
}

fn points_of(t : ObjectTriangle) -> TrianglePoints { return TrianglePoints(t.a.xyz, t.b.xyz, t.c.xyz); }

fn cloth_nodes(triangle : u32) -> vec3u {
  let first = 3u * triangle;
  return vec3u(cloth_triangles[first], cloth_triangles[first + 1u], cloth_triangles[first + 2u]);
}

fn cloth_points(nodes : vec3u) -> TrianglePoints {
  return TrianglePoints(predicted[nodes.x].xyz, predicted[nodes.y].xyz, predicted[nodes.z].xyz);
}

// Two cloth triangles that one invocation handles. Neighbours in the list are neighbours in the cloth: data read
// for one serves the other.
struct ClothPair {
  first : u32,   // the triangles' numbers
  second : u32,
  nodes_a : vec3u,
  nodes_b : vec3u,
  a : TrianglePoints,  // m, predicted
  b : TrianglePoints,
  query_a : Box,
  query_b : Box,
  use_a : bool,  // false: a node is not finite, or there is no second triangle
  use_b : bool,
}

fn all_finite(t : TrianglePoints) -> bool { return is_finite(t.a) && is_finite(t.b) && is_finite(t.c); }

fn cloth_pair(first : u32, cloth_count : u32) -> ClothPair {
  let second = min(first + 1u, cloth_count - 1u);
  let nodes_a = cloth_nodes(first);
  let nodes_b = cloth_nodes(second);
  let a = cloth_points(nodes_a);
  let b = cloth_points(nodes_b);
  return ClothPair(first, second, nodes_a, nodes_b, a, b, query_box(a), query_box(b), all_finite(a),
                   all_finite(b) && second > first);
}

// Adds a node's push: (thickness - signed distance of its previous position)+ along the normal. Source: Sung et al.,
// Algorithm 2. A kinematic node follows its motion: it is never pushed. Where there is no distance, the push is zero.
fn push_node(node : u32, base : vec3f, normal : vec3f) {
  let before = previous[node];
  if (before.w == 0.0) { return; }
  let offset = before.xyz - base;
  let push = clamp(step.contact.thickness - dot_fused(normal, offset), 0.0, step.contact.max_push);
  let units = select(vec3i(0), vec3i(round((step.contact.push_scale * push) * normal)), is_finite(offset));
  atomicAdd(&pushes[4u * node], units.x);
  atomicAdd(&pushes[4u * node + 1u], units.y);
  atomicAdd(&pushes[4u * node + 2u], units.z);
  atomicAdd(&pushes[4u * node + 3u], 1);
}

// The hits of one invocation, added to `statistics` once.
struct HitCount { hits : u32, hash : u32 }

fn add_pair(count : ptr<function, HitCount>, cloth_triangle : u32, nodes : vec3u, object_triangle : u32) {
  let object = object_triangles[object_triangle];
  let normal = vec3f(object.a.w, object.b.w, object.c.w);
  push_node(nodes.x, object.a.xyz, normal);
  push_node(nodes.y, object.a.xyz, normal);
  push_node(nodes.z, object.a.xyz, normal);
  (*count).hits += 1u;
  (*count).hash += hash_pair(cloth_triangle, object_ids[object_triangle]);
}

fn write_count(count : HitCount) {
  if (count.hits == 0u) { return; }
  atomicAdd(&statistics[kStatContacts], count.hits);
  atomicAdd(&statistics[kStatContactHash], count.hash);
}
