// Moves the colliders' points to their places at the start and at the end of a substep. One invocation per point.
// `points` holds all starts, all ends, how meshes are curved (curved.wgsl), then for each collider four rows: x, y
// and z of R·p + t at the start, and its spin.
// w of a start is the point's radius, of an end its friction; both stay.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
struct ColliderPlace {  // mirror: src/contact/proximity/collider_set.hpp
  rows : array<vec4f, 3>,
  shape : vec4f,  // first point of the shape before in `shapes` and of the one after, how far between; w: unused
  spin : vec4f,   // rad/s
}
//                                                                               elements                         unit
@group(0) @binding(0) var<uniform>             step   : StepBlock;
@group(0) @binding(1) var<storage, read>       places : array<ColliderPlace>; // colliders * (substeps + 1)
@group(0) @binding(2) var<storage, read>       shapes : array<vec4f>;         // m, then keyframes; w: collider + a kind
@group(0) @binding(3) var<storage, read_write> points : array<vec4f>;         // 4 * (point_count + colliders)    m
const kDirection = 0.25;  // of w: it turns but does not move
const kSpin = 0.5;        // of w: it is a collider's spin

fn placed(place : ColliderPlace, point : u32, kind : f32) -> vec3f {
  if (kind == kSpin) { return place.spin.xyz; }
  let before = shapes[u32(place.shape.x) + point].xyz;
  let after = shapes[u32(place.shape.y) + point].xyz;
  let p = vec4f(before + place.shape.z * (after - before), select(1.0, 0.0, kind == kDirection));
  return vec3f(dot(place.rows[0], p), dot(place.rows[1], p), dot(place.rows[2], p));
}

@compute @workgroup_size(kWorkgroupSize)
fn move_points(@builtin(global_invocation_id) id : vec3u) {
  let point = flat_index(id);
  let first_row = 4u * step.contact.point_count;
  let count = (arrayLength(&points) - first_row) / 4u;
  if (point < 4u * count) {
    let place = places[step.contact.first_place + point / 4u];
    points[first_row + point] = select(place.spin, place.rows[point % 4u % 3u], point % 4u < 3u);
  }
  if (point >= step.contact.point_count) { return; }
  let owner = shapes[point].w;
  let collider = u32(owner);
  let kind = owner - floor(owner);
  let now = places[step.contact.first_place + collider];
  let then = places[step.contact.first_place + count + collider];
  points[point] = vec4f(placed(now, point, kind), points[point].w);
  let end = step.contact.point_count + point;
  points[end] = vec4f(placed(then, point, kind), points[end].w);
}
