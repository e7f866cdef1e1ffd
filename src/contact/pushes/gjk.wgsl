// The distance of a triangle and a convex body by GJK (Gilbert, Johnson and Keerthi 1988; van den Bergen 1999), and the
// least depth where they overlap. docs/collision.md has the equations and the bound of the error;
// src/contact/reference/pushes/gjk.cpp has the same steps in double. The including kernel binds bodies, places and
// words (src/contact/pushes/convex_bodies.hpp). Its one kernel serves both methods.
#include "contact/pushes/triangle_pair.wgsl"  // dot_fused, cross_fused, largest

// Mirror: ConvexBody in src/contact/pushes/convex_bodies.hpp.
struct ConvexBody {
  low : vec4f,   // m
  high : vec4f,
  first_point : u32,  // in places
  points : u32,
  first_face : u32,   // in places: the unit normal, and the number of a corner
  faces : u32,
  first_edge : u32,   // in words, kEdgeWords each
  edges : u32,
  first_ring : u32,   // in words
  first_corner : u32, // in words, three a face
}
const kEdgeWords = 4u;
const kUnit = 5.9604644775390625e-08;  // 2^-24, of rounding
const kGap = 8.0 * kUnit;              // of the pair's size: close enough
const kDoubt = 48.0 * kUnit;           // of the pair's size: further, another way must tell
const kTouch = 0.0009765625;           // of the pair's size, 4 sqrt(kUnit): nearer, the direction is lost in rounding
const kNear = 0.015625;                // of the pair's size: nearer, a face's normal tells its direction better
const kMostIterations = 64u;
const kScan = 32u;       // points: more are climbed
const kNowhere = 3.0e38;

struct Simplex {
  at : array<vec3f, 4>,   // m: a corner of the triangle less a point of the body
  corner : array<u32, 4>,
  point : array<u32, 4>,
  weight : vec4f,
  count : u32,
  nearest : vec3f,  // m, its point nearest to 0
}

struct Search {
  simplex : Simplex,
  inside : bool,     // 0 is in it: the pair overlaps
  apart : bool,      // the pair is further apart than was asked for
  highest : u32,     // the point found last, where the next climb begins
  iterations : u32,
  gap : f32,         // m: the distance is at most so much too long
}

// Where a triangle is nearest to a body, or deepest in it.
struct ConvexContact {
  weights : vec3f,  // of the triangle's point p
  point : vec3f,    // m, the body's point q
  normal : vec3f,   // out of the body; p - q = distance normal
  distance : f32,   // m; kNowhere: further apart than was asked for
  iterations : u32,
  by_features : bool,  // GJK's own bounds were too far apart
}

fn length_of(v : vec3f) -> f32 {
  let size = largest(v);
  if (size == 0.0) { return 0.0; }
  let scaled = v / size;
  return size * sqrt(dot_fused(scaled, scaled));
}
fn unit_of(v : vec3f) -> vec3f {
  let scaled = v / largest(v);
  return scaled / sqrt(dot_fused(scaled, scaled));
}
fn place(body : ConvexBody, point : u32) -> vec3f { return places[body.first_point + point].xyz; }

// The point of a body that is highest along `way`.
fn highest_point(body : ConvexBody, way : vec3f, start : u32) -> u32 {
  if (body.points <= kScan) {
    var best = 0u;
    for (var p = 1u; p < body.points; p++) {
      if (dot_fused(way, place(body, p) - place(body, best)) > 0.0) { best = p; }
    }
    return best;
  }
  var at = start;
  for (var step = 0u; step < body.points; step++) {
    let here = place(body, at);
    let begin = words[body.first_ring + at];
    let end = words[body.first_ring + at + 1u];
    var next = at;
    var most = 0.0;
    for (var k = begin; k < end; k++) {
      let p = words[body.first_ring + k];
      let edge = place(body, p) - here;
      let rise = dot_fused(way, edge);
      if (rise > most && rise > 4.0 * kUnit * largest(edge)) { most = rise; next = p; }  // no circles by rounding
    }
    if (next == at) { break; }
    at = next;
  }
  return at;
}

struct NearestPoint { point : vec3f, square : f32, weight : vec4f }

fn take(best : ptr<function, NearestPoint>, point : vec3f, weight : vec4f) {
  let square = dot_fused(point, point);
  if (square < (*best).square) { *best = NearestPoint(point, square, weight); }
}

// The simplex without the vertices that its nearest point does not need. Takes the best of all of its features: what
// rounding does to one of them another makes good. Each is projected twice: from the point found first what is left is
// short, and so is its rounding.
fn reduced(given : Simplex) -> Simplex {
  var s = given;
  var best = NearestPoint(vec3f(0.0), kNowhere, vec4f(0.0));
  for (var i = 0u; i < s.count; i++) {
    var weight = vec4f(0.0);
    weight[i] = 1.0;
    take(&best, s.at[i], weight);
    for (var j = i + 1u; j < s.count; j++) {
      let a = s.at[i];
      let e1 = s.at[j] - a;
      let square = dot_fused(e1, e1);
      if (square > 0.0) {
        var t = -dot_fused(a, e1) / square;
        t -= dot_fused(t * e1 + a, e1) / square;
        if (t > 0.0 && t < 1.0) {
          weight = vec4f(0.0);
          weight[i] = 1.0 - t;
          weight[j] = t;
          take(&best, t * e1 + a, weight);
        }
      }
      for (var k = j + 1u; k < s.count; k++) {
        let e2 = s.at[k] - a;
        let n = cross_fused(e1, e2);
        let area = dot_fused(n, n);
        if (area <= 0.0) { continue; }
        var u = 0.0;
        var v = 0.0;
        for (var round = 0u; round < 2u; round++) {
          let foot = v * e2 + (u * e1 + a);
          u -= dot_fused(n, cross_fused(foot, e2)) / area;
          v -= dot_fused(n, cross_fused(e1, foot)) / area;
        }
        if (u > 0.0 && v > 0.0 && u + v < 1.0) {
          weight = vec4f(0.0);
          weight[i] = 1.0 - u - v;
          weight[j] = u;
          weight[k] = v;
          take(&best, v * e2 + (u * e1 + a), weight);
        }
      }
    }
  }
  var kept : Simplex;
  kept.nearest = best.point;
  for (var i = 0u; i < s.count; i++) {
    if (best.weight[i] <= 0.0) { continue; }
    kept.at[kept.count] = s.at[i];
    kept.corner[kept.count] = s.corner[i];
    kept.point[kept.count] = s.point[i];
    kept.weight[kept.count] = best.weight[i];
    kept.count++;
  }
  return kept;
}

// Whether 0 is inside of a simplex of four, beyond doubt.
fn surely_inside(given : Simplex) -> bool {
  if (given.count < 4u) { return false; }
  var s = given;
  for (var apex = 0u; apex < 4u; apex++) {
    let a = s.at[(apex + 1u) % 4u];
    let e1 = s.at[(apex + 2u) % 4u] - a;
    let e2 = s.at[(apex + 3u) % 4u] - a;
    let n = cross_fused(e1, e2);
    let to_apex = s.at[apex] - a;
    let of_origin = -dot_fused(n, a);
    let of_apex = dot_fused(n, to_apex);
    let tolerance = kRounding * (largest(e1) * largest(e2));
    if (abs(of_origin) <= tolerance * largest(a) || abs(of_apex) <= tolerance * largest(to_apex)) { return false; }
    if ((of_origin > 0.0) != (of_apex > 0.0)) { return false; }
  }
  return true;
}

// From 0 to the nearest point of a simplex. Where that is too near to have a direction, the normal of the face that it
// lies in.
fn direction_of(given : Simplex, v : vec3f, size : f32) -> vec3f {
  if (given.count == 3u && largest(v) <= kNear * size) {
    var s = given;
    let n = cross_fused(s.at[1] - s.at[0], s.at[2] - s.at[0]);
    if (largest(n) > 0.0) { return select(1.0, -1.0, dot_fused(n, s.at[0]) < 0.0) * unit_of(n); }
  }
  return unit_of(v);
}

// Searches for the point of the Minkowski difference of a triangle and a body that is nearest to 0, until it is further
// away than `reach`.
fn search(s : ptr<function, Search>, corners : array<vec3f, 3>, body : ConvexBody, size : f32, reach : f32) {
  var c = corners;
  (*s).simplex = Simplex();
  (*s).inside = false;
  (*s).apart = false;
  var v = c[0] - place(body, (*s).highest);
  if (all(v == vec3f(0.0))) { v = vec3f(0.0, 1.0, 0.0); }
  for (var round = 0u; round < kMostIterations; round++) {
    (*s).iterations++;
    let way = direction_of((*s).simplex, v, size);
    var corner = 0u;
    for (var k = 1u; k < 3u; k++) {
      if (dot_fused(way, c[k] - c[corner]) < 0.0) { corner = k; }
    }
    let point = highest_point(body, way, (*s).highest);
    (*s).highest = point;
    let at = c[corner] - place(body, point);
    // No point of the difference is lower along the way.
    if (dot_fused(way, at) - 4.0 * kGap * size > reach) {
      (*s).apart = true;
      return;
    }
    let count = (*s).simplex.count;
    (*s).gap = dot_fused(way, v - at);
    if (count > 0u && (*s).gap <= kGap * size) { return; }
    for (var k = 0u; k < count; k++) {
      if ((*s).simplex.corner[k] == corner && (*s).simplex.point[k] == point) { return; }
    }
    var grown = (*s).simplex;
    grown.at[count] = at;
    grown.corner[count] = corner;
    grown.point[count] = point;
    grown.count = count + 1u;
    if (surely_inside(grown)) {
      (*s).inside = true;
      return;
    }
    let next = reduced(grown);
    if (round > 0u && dot_fused(next.nearest, next.nearest) >= dot_fused(v, v)) { return; }  // rounding allows no more
    (*s).simplex = next;
    v = next.nearest;
    if (all(v == vec3f(0.0))) { return; }
  }
}

fn add_vertex(s : ptr<function, Simplex>, corners : array<vec3f, 3>, body : ConvexBody, corner : u32, point : u32) {
  var c = corners;
  let count = (*s).count;
  (*s).at[count] = c[corner] - place(body, point);
  (*s).corner[count] = corner;
  (*s).point[count] = point;
  (*s).count = count + 1u;
}

// The simplex of two that is nearer to 0.
fn nearer(best : Simplex, given : Simplex) -> Simplex {
  let found = reduced(given);
  if (dot_fused(found.nearest, found.nearest) < dot_fused(best.nearest, best.nearest)) { return found; }
  return best;
}

// Of a pair that is apart: the nearest of all corners and faces, points and the triangle, edges and edges, given one
// that may be further. Linear in the body's size, for the few pairs that GJK in f32 leaves in doubt: those that all but
// touch. Most features are further away by their boxes.
fn nearest_features(corners : array<vec3f, 3>, body : ConvexBody, given : Simplex) -> Simplex {
  var best = given;
  let cloth = box_of(TrianglePoints(corners[0], corners[1], corners[2]));
  for (var e = 0u; e < body.edges; e++) {
    let word = body.first_edge + kEdgeWords * e;
    let a = place(body, words[word]);
    let b = place(body, words[word + 1u]);
    if (further(cloth, min(a, b), max(a, b), best)) { continue; }
    for (var k = 0u; k < 3u; k++) {
      var pair = Simplex();  // anew in each round
      for (var end = 0u; end < 2u; end++) {
        add_vertex(&pair, corners, body, k, words[word + end]);
        add_vertex(&pair, corners, body, (k + 1u) % 3u, words[word + end]);
      }
      best = nearer(best, pair);
    }
  }
  for (var f = 0u; f < body.faces; f++) {
    let word = body.first_corner + 3u * f;
    let a = place(body, words[word]);
    let b = place(body, words[word + 1u]);
    let c = place(body, words[word + 2u]);
    if (further(cloth, min(min(a, b), c), max(max(a, b), c), best)) { continue; }
    for (var k = 0u; k < 3u; k++) {
      var pair = Simplex();
      for (var corner = 0u; corner < 3u; corner++) { add_vertex(&pair, corners, body, k, words[word + corner]); }
      best = nearer(best, pair);
    }
  }
  for (var p = 0u; p < body.points; p++) {
    let a = place(body, p);
    if (further(cloth, a, a, best)) { continue; }
    var pair = Simplex();
    for (var k = 0u; k < 3u; k++) { add_vertex(&pair, corners, body, k, p); }
    best = nearer(best, pair);
  }
  return best;
}

// Whether a box is further from another than the nearest point of a simplex is from 0.
fn further(cloth : Box, low : vec3f, high : vec3f, best : Simplex) -> bool {
  let between = max(max(low - cloth.high, cloth.low - high), vec3f(0.0));
  return dot_fused(between, between) > dot_fused(best.nearest, best.nearest);
}

// How far a body reaches along a unit axis from `base`: most and least.
fn extent(body : ConvexBody, axis : vec3f, base : vec3f) -> vec2f {
  var most = -kNowhere;
  var least = kNowhere;
  for (var p = 0u; p < body.points; p++) {
    let h = dot_fused(axis, place(body, p) - base);
    most = max(most, h);
    least = min(least, h);
  }
  return vec2f(most, least);
}

// The direction of a face, of the triangle or of two edges that tells the pair furthest apart, and w: how far.
// Negative: they overlap by no less in any direction. Of two edges only those whose common normal lies between the
// normals of the faces at the body's edge can be it.
fn separation(corners : array<vec3f, 3>, body : ConvexBody) -> vec4f {
  var c = corners;
  var best = vec4f(0.0, 1.0, 0.0, -kNowhere);
  for (var f = 0u; f < body.faces; f++) {
    let face = places[body.first_face + f];
    let base = place(body, u32(face.w));
    let gap = min(min(dot_fused(face.xyz, c[0] - base), dot_fused(face.xyz, c[1] - base)),
                  dot_fused(face.xyz, c[2] - base));
    if (gap > best.w) { best = vec4f(face.xyz, gap); }
  }
  let n = cross_fused(c[1] - c[0], c[2] - c[0]);
  if (largest(n) > 0.0) {
    let axis = unit_of(n);
    let of_body = extent(body, axis, c[0]);
    let h1 = dot_fused(axis, c[1] - c[0]);
    let h2 = dot_fused(axis, c[2] - c[0]);
    let above = min(min(h1, h2), 0.0) - of_body.x;
    let below = of_body.y - max(max(h1, h2), 0.0);
    if (above > best.w) { best = vec4f(axis, above); }
    if (below > best.w) { best = vec4f(-axis, below); }
  }
  for (var e = 0u; e < body.edges; e++) {
    let word = body.first_edge + kEdgeWords * e;
    let a = place(body, words[word]);
    let edge = place(body, words[word + 1u]) - a;
    let left = places[body.first_face + words[word + 2u]].xyz;
    let right = places[body.first_face + words[word + 3u]].xyz;
    for (var k = 0u; k < 3u; k++) {
      let side = c[(k + 1u) % 3u] - c[k];
      let of_left = dot_fused(left, side);
      let of_right = dot_fused(right, side);
      if ((of_left > 0.0 && of_right > 0.0) || (of_left < 0.0 && of_right < 0.0)) { continue; }
      let both = cross_fused(edge, side);
      if (largest(both) == 0.0) { continue; }
      let axis = select(1.0, -1.0, dot_fused(both, left + right) < 0.0) * unit_of(both);
      let gap = min(min(dot_fused(axis, c[0] - a), dot_fused(axis, c[1] - a)), dot_fused(axis, c[2] - a));
      if (gap <= best.w) { continue; }
      // Were the axis not between the normals, for rounding, the edge would not be highest.
      let top = place(body, highest_point(body, axis, words[word]));
      let whole = gap - max(dot_fused(axis, top - a), 0.0);
      if (whole > best.w) { best = vec4f(axis, whole); }
    }
  }
  return best;
}

// The largest coordinate difference of a corner and a point: what errors are measured by.
fn pair_size(corners : array<vec3f, 3>, body : ConvexBody) -> f32 {
  var c = corners;
  let low = min(min(c[0], c[1]), c[2]);
  let high = max(max(c[0], c[1]), c[2]);
  return max(largest(low - body.high.xyz), largest(high - body.low.xyz));
}

// `reach`: of pairs further apart only that is found. Places are finite.
fn convex_contact(corners : array<vec3f, 3>, body : ConvexBody, reach : f32) -> ConvexContact {
  let size = pair_size(corners, body);
  var found : Search;
  search(&found, corners, body, size, reach);
  var contact : ConvexContact;
  contact.distance = kNowhere;
  contact.iterations = found.iterations;
  if (found.apart) { return contact; }
  contact.distance = length_of(found.simplex.nearest);
  if (!found.inside && contact.distance > kTouch * size && found.gap <= kDoubt * size) {
    contact.normal = unit_of(found.simplex.nearest);
  } else {
    let apart = separation(corners, body);  // no more than the distance
    let overlap = found.inside || apart.w <= 0.0;
    if (!overlap && contact.distance - apart.w > kDoubt * size) {
      contact.by_features = true;
      found.simplex = nearest_features(corners, body, found.simplex);
      contact.distance = length_of(found.simplex.nearest);
    }
    if (overlap) { contact.distance = apart.w; }
    if (contact.distance > kTouch * size) {
      contact.normal = unit_of(found.simplex.nearest);
    } else {
      // The points are those of the triangle moved out along the direction that tells the pair apart best.
      contact.normal = apart.xyz;
      let out = 0.25 * size - apart.w;
      var moved = corners;
      for (var k = 0u; k < 3u; k++) { moved[k] += out * apart.xyz; }
      search(&found, moved, body, size, kNowhere);
      contact.iterations = found.iterations;
    }
  }
  for (var k = 0u; k < found.simplex.count; k++) {
    let weight = found.simplex.weight[k];
    contact.weights[found.simplex.corner[k]] += weight;
    contact.point += weight * place(body, found.simplex.point[k]);
  }
  return contact;
}
