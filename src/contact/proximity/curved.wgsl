// A mesh as the smooth surface that it stands for, which turns its normal along it: equation (11c) of
// docs/solvers/multigrid.md. The including kernel binds `step` and `points`.
#include "state/step.wgsl"
#include "state/contact.wgsl"
const kShapeWords = 2u;     // of a point, behind the ends: collider_set.hpp
const kColliderRows = 4u;   // of `points`, behind these: move_points.wgsl
const kNormalUnits = 127.0;  // of the parts of a normal, which are below 256 in steps of one
const kSameSector = 0.765;  // mirror: src/mesh/curvature.hpp
const kLeastSpread = 0.5;   // of a surface's radius; mirror: src/contact/rules/contact_law.hpp

// dn/dx, symmetric, 1/m; in the mesh's own space, with the normal on the side that `normal` shows.
struct CurvedSurface {
  diagonal : vec3f,  // xx, yy, zz
  beside : vec3f,    // xy, xz, yz
  normal : vec3f,
  row : u32,         // of `points`: where the mesh's place is
}
fn shape_along(surface : CurvedSurface, v : vec3f) -> vec3f {
  let b = surface.beside;
  return surface.diagonal * v + vec3f(b.x * v.y + b.y * v.z, b.x * v.x + b.z * v.z, b.y * v.x + b.z * v.y);
}
fn is_flat(surface : CurvedSurface) -> bool {
  return all(surface.diagonal == vec3f(0.0)) && all(surface.beside == vec3f(0.0));
}

fn shape_word(id : u32) -> u32 { return 2u * step.contact.point_count + kShapeWords * (id & kIdBits); }
fn row_of_collider(id : u32) -> u32 {
  let collider = u32(points[shape_word(id) + 1u].w);
  return (2u + kShapeWords) * step.contact.point_count + kColliderRows * collider;
}

// The vectors of a collider's own space, and those of the world.
fn to_own(row : u32, v : vec3f) -> vec3f {
  return v.x * points[row].xyz + v.y * points[row + 1u].xyz + v.z * points[row + 2u].xyz;
}
fn to_world(row : u32, v : vec3f) -> vec3f {
  return vec3f(dot(points[row].xyz, v), dot(points[row + 1u].xyz, v), dot(points[row + 2u].xyz, v));
}

// Where a pair of direction n touches a mesh: the mean over the mesh's vertices, without those that belong to another
// side of a crease.
fn surface_at(ids : vec4u, weights : vec4f, n : vec3f) -> CurvedSurface {
  var sum = CurvedSurface(vec3f(0.0), vec3f(0.0), vec3f(0.0), 0u);
  for (var role = 0u; role < role_count(ids); role++) {
    if (!is_collider(ids[role])) { continue; }
    let word = shape_word(ids[role]);
    let packed = u32(points[word].w);
    sum.row = row_of_collider(ids[role]);
    let normal = vec3f(vec3u(packed, packed >> 8u, packed >> 16u) & vec3u(255u)) - kNormalUnits;
    if (abs(dot(normal, to_own(sum.row, n))) < kSameSector * kNormalUnits) { continue; }
    let w = abs(weights[role]);
    sum.diagonal += w * points[word].xyz;
    sum.beside += w * points[word + 1u].xyz;
    sum.normal += w * normal;
  }
  return sum;
}

// The direction n of a pair, toward cloth, as it is for a vertex, and by how much more than along n that goes away.
struct Turned { direction : vec3f, more : f32 }
// `before` and `after`: from where the pair touches to the vertex, over the surface, at the start of the substep and
// where its velocity leads, m.
fn turned_by(surface : CurvedSurface, n : vec3f, distance : f32, before : vec3f, after : vec3f) -> Turned {
  let row = surface.row;
  let own_n = to_own(row, n);
  let side = select(1.0, -1.0, dot(surface.normal, own_n) < 0.0);
  let first = to_own(row, before - dot(n, before) * n);
  let then = to_own(row, after - dot(n, after) * n);
  let turn = side * shape_along(surface, then);
  let bent = dot(then, turn);
  let bent_before = side * dot(first, shape_along(surface, first));
  let size = dot(then, then);
  let less = select(1.0, 1.0 / max(1.0 + distance * bent / size, kLeastSpread), size > 0.0);
  let direction = n + to_world(row, less * turn) + step.time.dt * cross(points[row + 3u].xyz, n);
  return Turned(direction / length(direction), 0.5 * less * (bent - bent_before));
}
