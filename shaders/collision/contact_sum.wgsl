// What the pairs of one cloth triangle add to its three nodes. Summed in registers, then added to `pushes` at once:
// integer sums do not depend on the order of triangles or threads.
// The including kernel binds step, predicted, previous, cloth_triangles, object_triangles, object_ids, pushes, statistics.
#include "shared/step.wgsl"
#include "shared/statistics.wgsl"
#include "collision/triangle_pair.wgsl"

// Mirror: ObjectTriangle in src/collision/object_triangles.hpp.
struct ObjectTriangle {
  a : vec4f,  // m; the three w are the outward unit normal, rounded from double on the host: no kernel divides
  b : vec4f,
  c : vec4f,
}

struct ContactSum {
  hits : u32,
  hash : u32,
  push_a : vec3i,  // 1/step.push_scale m, for each node
  push_b : vec3i,
  push_c : vec3i,
}

fn points_of(t : ObjectTriangle) -> TrianglePoints { return TrianglePoints(t.a.xyz, t.b.xyz, t.c.xyz); }

fn cloth_nodes(triangle : u32) -> vec3u {
  let first = 3u * triangle;
  return vec3u(cloth_triangles[first], cloth_triangles[first + 1u], cloth_triangles[first + 2u]);
}

fn cloth_points(nodes : vec3u) -> TrianglePoints {
  return TrianglePoints(predicted[nodes.x].xyz, predicted[nodes.y].xyz, predicted[nodes.z].xyz);
}

fn all_finite(t : TrianglePoints) -> bool { return is_finite(t.a) && is_finite(t.b) && is_finite(t.c); }

// (thickness - signed distance of the node's previous position)+, along the normal. Source: Sung et al., Algorithm 2.
fn push_along(normal : vec3f, base : vec3f, node : u32) -> vec3i {
  let offset = previous[node].xyz - base;
  if (!is_finite(offset)) { return vec3i(0); }
  let push = clamp(step.thickness - dot_fused(normal, offset), 0.0, step.max_push);
  return vec3i(round((step.push_scale * push) * normal));
}

fn add_pair(sum : ptr<function, ContactSum>, cloth_triangle : u32, nodes : vec3u, object_triangle : u32) {
  let object = object_triangles[object_triangle];
  let normal = vec3f(object.a.w, object.b.w, object.c.w);
  (*sum).hits += 1u;
  (*sum).hash += hash_pair(cloth_triangle, object_ids[object_triangle]);
  (*sum).push_a += push_along(normal, object.a.xyz, nodes.x);
  (*sum).push_b += push_along(normal, object.a.xyz, nodes.y);
  (*sum).push_c += push_along(normal, object.a.xyz, nodes.z);
}

// A kinematic node follows its motion: it is never pushed.
fn write_node(node : u32, push : vec3i, count : u32) {
  if (previous[node].w == 0.0) { return; }
  atomicAdd(&pushes[4u * node], push.x);
  atomicAdd(&pushes[4u * node + 1u], push.y);
  atomicAdd(&pushes[4u * node + 2u], push.z);
  atomicAdd(&pushes[4u * node + 3u], i32(count));
}

fn write_sum(sum : ptr<function, ContactSum>, nodes : vec3u) {
  if ((*sum).hits == 0u) { return; }
  write_node(nodes.x, (*sum).push_a, (*sum).hits);
  write_node(nodes.y, (*sum).push_b, (*sum).hits);
  write_node(nodes.z, (*sum).push_c, (*sum).hits);
  atomicAdd(&statistics[kStatHits], (*sum).hits);
  atomicAdd(&statistics[kStatHitHash], (*sum).hash);
}
