// The direction in which an edge and the triangle that it crosses come apart. Equations, and what they are
// taken from: docs/contact.md, "Untangling".

const kFromCloth = 0u;
const kFromOpenMesh = 1u;    // has a rim
const kFromClosedMesh = 2u;  // has an outside

struct Sheet {
  normal : vec3f,  // unit
  inward : vec3f,  // unit, in its plane: away from the sheet's rim
  rim : f32,       // distance of the crossing from that, m
  kind : u32,
}

const kContourGain = 4.0;   // of equation (7a): a contour that turns by 1/4 rad in a crossing has the whole speed
const kRimPart = 0.5;       // of the speed, where the contour says nothing
const kOutwardPart = 0.25;
const kLeastOutward = 0.25;
const kLeastSlope = 0.1;    // lower bound of the slope, so that grazing crossings give finite distances

// The rim's distance is linear in a triangle: its gradient is a sum of the gradients of the weights.
fn sheet_of(a : vec3f, b : vec3f, c : vec3f, rim : vec3f, at : vec3f, kind : u32) -> Sheet {
  let n = unit(cross(b - a, c - a));
  let gradient = (rim.y - rim.x) * cross(c - a, n) + (rim.z - rim.x) * cross(n, b - a);
  return Sheet(n, unit(gradient), dot(rim, at), kind);
}

// The unit direction in which a triangle with the edge direction e and the corner `tip` goes on from the edge along its
// intersection with a plane.
fn contour_from_edge(p : vec3f, e : vec3f, tip : vec3f, plane : vec3f) -> vec3f {
  let arm = tip - p;
  let across = arm - dot(arm, e) * e;
  let line = unit(cross(cross(e, across), plane));
  return select(-line, line, dot(line, across) > 0.0);
}

// Equation (7a): the part of the speed along the triangle's normal by which the contour grows shorter.
fn contour_pull(e : vec3f, turn : vec3f, normal : vec3f) -> f32 {
  let slope = dot(e, normal);
  let steep = select(min(slope, -kLeastSlope), max(slope, kLeastSlope), slope > 0.0);
  return clamp(-2.0 * kContourGain * dot(e, turn) / steep, -1.0, 1.0);
}

// Equation (7b): the sheet that has less way to its rim is drawn through the other.
fn rim_pull(own : Sheet, other : Sheet) -> vec3f {
  let slope = dot(own.inward, other.normal);
  return select(-1.0, 1.0, slope > 0.0) * select(0.0, 1.0, slope != 0.0) * other.normal;
}
fn rim_way(own : Sheet, other : Sheet) -> f32 { return own.rim / max(abs(dot(own.inward, other.normal)), kLeastSlope); }

// Equation (7c): cloth that has its own rim inside a body is drawn out, and other cloth goes the way by which the body
// leaves it.
fn outward(cloth : Sheet, body : Sheet) -> vec3f {
  let slope = dot(cloth.normal, body.normal);
  if (abs(slope) > kLeastOutward) { return select(-1.0, 1.0, slope > 0.0) * cloth.normal + kOutwardPart * body.normal; }
  if (dot(cloth.inward, body.normal) > 0.0) { return body.normal; }
  return -rim_pull(body, cloth);
}

// How the edge has to move against the triangle, in parts of the speed: at most 1.
fn untangling(edge : Sheet, e : vec3f, turn : vec3f, face : Sheet) -> vec3f {
  var way = vec3f(0.0);
  if (face.kind == kFromClosedMesh) {
    way = outward(edge, face);
  } else if (edge.kind == kFromClosedMesh) {
    way = -outward(face, edge);
  } else {
    way = contour_pull(e, turn, face.normal) * face.normal;
    if (rim_way(edge, face) <= rim_way(face, edge)) {
      way += kRimPart * rim_pull(edge, face);
    } else {
      way -= kRimPart * rim_pull(face, edge);
    }
  }
  return way / max(1.0, length(way));
}
