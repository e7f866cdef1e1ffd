// Colliders as rigid bodies meet them: a surface, the points that stand on others, and edges. In its own frame one
// lies about its centre, a box and a body along its principal axes, a capsule along x, a plane across y. The including
// kernel binds `rigid`, `hulls` and `places`. Source: docs/rigid.md, Touches.
const kPlaceVectors = 5u;  // of ColliderPlace, src/contact/proximity/collider_set.hpp

fn rows_of(c : u32) -> u32 { return kPlaceVectors * (step.contact.first_place + c); }
fn direction_in_world(c : u32, v : vec3f) -> vec3f {
  let word = kRigidWords * c;
  if (number_at(word + kRigidInverseMass) > 0.0) { return rotated(quaternion_at(word + kRigidTurn), v); }
  let rest = rotated(quaternion_at(word + kRigidAxes), v);
  let row = rows_of(c);
  return vec3f(dot(places[row].xyz, rest), dot(places[row + 1u].xyz, rest), dot(places[row + 2u].xyz, rest));
}
fn middle_of(c : u32) -> vec3f {
  let word = kRigidWords * c;
  if (number_at(word + kRigidInverseMass) > 0.0) { return vector_at(word + kRigidPlace); }
  let p = vec4f(vector_at(word + kRigidCenter), 1.0);
  let row = rows_of(c);
  return vec3f(dot(places[row], p), dot(places[row + 1u], p), dot(places[row + 2u], p));
}
fn place_in_world(c : u32, p : vec3f) -> vec3f { return middle_of(c) + direction_in_world(c, p); }
fn place_in_own(c : u32, p : vec3f) -> vec3f {
  let word = kRigidWords * c;
  let d = p - middle_of(c);
  if (number_at(word + kRigidInverseMass) > 0.0) { return rotated(conjugate(quaternion_at(word + kRigidTurn)), d); }
  let row = rows_of(c);
  let rest = d.x * places[row].xyz + d.y * places[row + 1u].xyz + d.z * places[row + 2u].xyz;
  return rotated(conjugate(quaternion_at(word + kRigidAxes)), rest);
}

fn from_core(away : vec3f, radius : f32) -> vec4f {
  let size = length(away);
  return vec4f(select(vec3f(0.0, 1.0, 0.0), away / size, size > 0.0), size - radius);
}
// By the face that a place is in or above, or else by the nearest edge.
const kOnFace = 1e-6;  // of an extent: what is no farther beside a face is on it
fn depth_of_hull(c : u32, p : vec3f) -> vec4f {
  let word = kRigidWords * c;
  let first = rigid[word + kRigidFirst] + rigid[word + kRigidCorners];
  let faces = rigid[word + kRigidFaces];
  var most = vec4f(0.0, 1.0, 0.0, -3e38);
  for (var k = 0u; k < faces; k++) {
    let face = hulls[first + k];
    let gap = dot(face.xyz, p) - face.w;
    if (gap > most.w) { most = vec4f(face.xyz, gap); }
  }
  if (most.w <= 0.0) { return most; }
  let foot = p - most.w * most.xyz;
  let spared = kOnFace * number_at(word + kRigidExtent);
  var is_above = true;
  for (var k = 0u; k < faces; k++) {
    let face = hulls[first + k];
    is_above = is_above && dot(face.xyz, foot) - face.w <= spared;
  }
  if (is_above) { return most; }
  var nearest = vec4f(most.xyz, 3e38);
  for (var k = 0u; k < rigid[word + kRigidEdges]; k++) {
    let at = first + faces + 2u * k;
    let along = hulls[at + 1u].xyz;
    let r = p - hulls[at].xyz;
    let offset = r - clamp(dot(r, along) / dot(along, along), 0.0, 1.0) * along;
    let distance = length(offset);
    if (distance > 0.0 && distance < nearest.w) { nearest = vec4f(offset / distance, distance); }
  }
  return nearest;
}
// The direction out of a surface, and how far a place is from it, m.
fn depth_of(c : u32, p : vec3f) -> vec4f {
  let word = kRigidWords * c;
  let kind = rigid[word + kRigidKind];
  let half = vector_at(word + kRigidHalf);
  let radius = number_at(word + kRigidRadius);
  if (kind == kBall) { return from_core(p, radius); }
  if (kind == kCapsule) { return from_core(p - vec3f(clamp(p.x, -half.x, half.x), 0.0, 0.0), radius); }
  if (kind == kPlane) { return vec4f(0.0, 1.0, 0.0, p.y); }
  if (kind == kBox) {
    let over = p - clamp(p, -half, half);
    if (any(over != vec3f(0.0))) { return from_core(over, 0.0); }
    let inside = half - abs(p);
    var axis = 0u;
    if (inside.y < inside.x) { axis = 1u; }
    if (inside.z < inside[axis]) { axis = 2u; }
    var out = vec4f(0.0, 0.0, 0.0, -inside[axis]);
    out[axis] = select(1.0, -1.0, p[axis] < 0.0);
    return out;
  }
  return depth_of_hull(c, p);
}

fn foot_count(c : u32) -> u32 {
  let word = kRigidWords * c;
  switch rigid[word + kRigidKind] {
    case kBall: { return 1u; }
    case kCapsule: { return 2u; }
    case kBox: { return 8u; }
    case kHull: { return rigid[word + kRigidCorners]; }
    default: { return 0u; }
  }
}
fn foot_of(c : u32, k : u32) -> vec3f {
  let word = kRigidWords * c;
  let half = vector_at(word + kRigidHalf);
  switch rigid[word + kRigidKind] {
    case kCapsule: { return vec3f(select(-half.x, half.x, k == 1u), 0.0, 0.0); }
    case kBox: { return select(-half, half, (vec3u(k) & vec3u(1u, 2u, 4u)) != vec3u(0u)); }
    case kHull: { return hulls[rigid[word + kRigidFirst] + k].xyz; }
    default: { return vec3f(0.0); }
  }
}

// A face of a box or a hull, in its own frame: outward normal, and how far from the centre, m.
const kSameFace = 0.9999;  // the cosine between triangles of one face of a hull
fn has_faces(c : u32) -> bool {
  let kind = rigid[kRigidWords * c + kRigidKind];
  return kind == kBox || kind == kHull;
}
fn face_count(c : u32) -> u32 {
  let word = kRigidWords * c;
  return select(rigid[word + kRigidFaces], 6u, rigid[word + kRigidKind] == kBox);
}
fn face_of(c : u32, k : u32) -> vec4f {
  let word = kRigidWords * c;
  if (rigid[word + kRigidKind] != kBox) { return hulls[rigid[word + kRigidFirst] + rigid[word + kRigidCorners] + k]; }
  var face = vec4f(0.0);
  face[k / 2u] = select(-1.0, 1.0, k % 2u == 1u);
  face.w = vector_at(word + kRigidHalf)[k / 2u];
  return face;
}
// The face of c beyond which the corners of another lie farthest, or in which they are least deep; of what has no faces
// none, the least far.
struct Toward { face : vec4f, apart : f32 }
fn face_toward(c : u32, other : u32) -> Toward {
  var best = Toward(vec4f(0.0), -3e38);
  for (var k = 0u; k < face_count(c); k++) {
    let face = face_of(c, k);
    var apart = 3e38;
    for (var corner = 0u; corner < foot_count(other); corner++) {
      let place = place_in_own(c, place_in_world(other, foot_of(other, corner)));
      apart = min(apart, dot(face.xyz, place) - face.w);
    }
    if (apart > best.apart) { best = Toward(face, apart); }
  }
  return best;
}
// How far a place is beside a face of c, beyond the nearest of the others, m.
fn beside(c : u32, face : vec4f, p : vec3f) -> f32 {
  var most = -3e38;
  for (var k = 0u; k < face_count(c); k++) {
    let other = face_of(c, k);
    if (dot(other.xyz, face.xyz) < kSameFace) { most = max(most, dot(other.xyz, p) - other.w); }
  }
  return most;
}
// Whether no corner of c is farther along n than a place, by more than is spared, m.
fn is_farthest(c : u32, n : vec3f, place : vec3f, spared : f32) -> bool {
  for (var k = 0u; k < foot_count(c); k++) {
    if (dot(n, place_in_world(c, foot_of(c, k)) - place) > spared) { return false; }
  }
  return true;
}

struct Rod { start : vec3f, along : vec3f }
fn rod_count(c : u32) -> u32 {
  switch rigid[kRigidWords * c + kRigidKind] {
    case kCapsule: { return 1u; }
    case kBox: { return 12u; }
    case kHull: { return rigid[kRigidWords * c + kRigidEdges]; }
    default: { return 0u; }
  }
}
// Of a box: three from each of the corners 0, 3, 5 and 6, no two of which share an edge.
fn rod_of(c : u32, k : u32) -> Rod {
  let half = vector_at(kRigidWords * c + kRigidHalf);
  if (rigid[kRigidWords * c + kRigidKind] == kCapsule) {
    return Rod(vec3f(-half.x, 0.0, 0.0), vec3f(2.0 * half.x, 0.0, 0.0));
  }
  if (rigid[kRigidWords * c + kRigidKind] == kHull) {
    let word = kRigidWords * c;
    let at = rigid[word + kRigidFirst] + rigid[word + kRigidCorners] + rigid[word + kRigidFaces] + 2u * k;
    return Rod(hulls[at].xyz, hulls[at + 1u].xyz);
  }
  var corner = k / 3u;
  corner = select(select(select(6u, 5u, corner == 2u), 3u, corner == 1u), 0u, corner == 0u);
  let start = foot_of(c, corner);
  var along = vec3f(0.0);
  along[k % 3u] = -2.0 * start[k % 3u];
  return Rod(start, along);
}

// Any direction square to n, unit.
fn square_to_normal(n : vec3f) -> vec3f {
  let other = select(vec3f(0.0, 1.0, 0.0), vec3f(1.0, 0.0, 0.0), abs(n.x) < 0.6);
  let s = cross(n, other);
  return s / length(s);
}
