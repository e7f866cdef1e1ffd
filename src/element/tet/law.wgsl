// An elastic tetrahedron: the same as law.hpp in f32. Source: docs/bodies.md, The laws.
const kTetNeoHookean = 0u;
const kSweeps = 6;  // of Jacobi: f32 has no more digits to win

struct SolidLaw {  // mirror: src/method/solid_buffers.hpp
  mu : f32,        // Pa
  lambda : f32,    // Pa
  delay : f32,     // s
  energy : u32,
}

// At rest: the slopes of the last three corners' shape functions, 1/m; volume, m³.
struct TetRest {
  b : vec3f,
  c : vec3f,
  d : vec3f,
  volume : f32,
}

fn tet_slope(rest : TetRest, corner : u32) -> vec3f {
  if (corner == 0u) { return -(rest.b + rest.c + rest.d); }
  if (corner == 1u) { return rest.b; }
  return select(rest.d, rest.c, corner == 2u);
}

fn outer_product(a : vec3f, b : vec3f) -> mat3x3f { return mat3x3f(b.x * a, b.y * a, b.z * a); }

// F, or its rate, by the spans from the first corner to the others.
fn tet_deformation(rest : TetRest, b : vec3f, c : vec3f, d : vec3f) -> mat3x3f {
  return outer_product(b, rest.b) + outer_product(c, rest.c) + outer_product(d, rest.d);
}

fn cofactor(f : mat3x3f) -> mat3x3f { return mat3x3f(cross(f[1], f[2]), cross(f[2], f[0]), cross(f[0], f[1])); }
fn contraction(a : mat3x3f, b : mat3x3f) -> f32 { return dot(a[0], b[0]) + dot(a[1], b[1]) + dot(a[2], b[2]); }
fn scaled_identity(s : f32) -> mat3x3f { return mat3x3f(s, 0.0, 0.0, 0.0, s, 0.0, 0.0, 0.0, s); }

// The sine and cosine that set the entry pq of a symmetric matrix to zero, and the tangent.
fn jacobi(pp : f32, qq : f32, pq : f32) -> vec3f {
  if (pq == 0.0) { return vec3f(0.0, 1.0, 0.0); }
  let theta = (qq - pp) / (2.0 * pq);
  let size = abs(theta);
  // Beyond 1e18 the square overflows, and t is half of the inverse.
  let root = select(sqrt(size * size + 1.0), size, size > 1e9);
  let t = select(1.0, -1.0, theta < 0.0) / (size + root);
  let c = 1.0 / sqrt(t * t + 1.0);
  return vec3f(t * c, c, t);
}

// Sets the entry pq of a symmetric matrix to zero, and turns the columns of v with it. Called with literals, so that
// drivers keep the matrices in registers.
fn set_to_zero(a : ptr<function, array<vec4f, 4>>, v : ptr<function, array<vec4f, 4>>, p : i32, q : i32) {
  let turn = jacobi((*a)[p][p], (*a)[q][q], (*a)[p][q]);
  let s = turn.x;
  let c = turn.y;
  let kp = vec4f((*a)[0][p], (*a)[1][p], (*a)[2][p], (*a)[3][p]);
  let kq = vec4f((*a)[0][q], (*a)[1][q], (*a)[2][q], (*a)[3][q]);
  let new_p = c * kp - s * kq;
  let new_q = s * kp + c * kq;
  (*a)[0][p] = new_p.x;
  (*a)[1][p] = new_p.y;
  (*a)[2][p] = new_p.z;
  (*a)[3][p] = new_p.w;
  (*a)[0][q] = new_q.x;
  (*a)[1][q] = new_q.y;
  (*a)[2][q] = new_q.z;
  (*a)[3][q] = new_q.w;
  let row_p = (*a)[p];
  let row_q = (*a)[q];
  (*a)[p] = c * row_p - s * row_q;
  (*a)[q] = s * row_p + c * row_q;
  let column_p = (*v)[p];
  let column_q = (*v)[q];
  (*v)[p] = c * column_p - s * column_q;
  (*v)[q] = s * column_p + c * column_q;
}

// The rotation that is nearest to F: Horn 1987.
fn nearest_rotation(f : mat3x3f) -> mat3x3f {
  let size = max(max(length(f[0]), length(f[1])), length(f[2]));
  if (!(size > 0.0)) { return scaled_identity(1.0); }
  let g = f * (1.0 / size);  // f[column][row]
  var a : array<vec4f, 4>;
  a[0] = vec4f(g[0].x + g[1].y + g[2].z, g[1].z - g[2].y, g[2].x - g[0].z, g[0].y - g[1].x);
  a[1] = vec4f(a[0].y, g[0].x - g[1].y - g[2].z, g[1].x + g[0].y, g[0].z + g[2].x);
  a[2] = vec4f(a[0].z, a[1].z, g[1].y - g[0].x - g[2].z, g[2].y + g[1].z);
  a[3] = vec4f(a[0].w, a[1].w, a[2].w, g[2].z - g[0].x - g[1].y);
  var v : array<vec4f, 4>;  // columns
  v[0] = vec4f(1.0, 0.0, 0.0, 0.0);
  v[1] = vec4f(0.0, 1.0, 0.0, 0.0);
  v[2] = vec4f(0.0, 0.0, 1.0, 0.0);
  v[3] = vec4f(0.0, 0.0, 0.0, 1.0);
  for (var sweep = 0; sweep < kSweeps; sweep++) {
    set_to_zero(&a, &v, 0, 1);
    set_to_zero(&a, &v, 0, 2);
    set_to_zero(&a, &v, 0, 3);
    set_to_zero(&a, &v, 1, 2);
    set_to_zero(&a, &v, 1, 3);
    set_to_zero(&a, &v, 2, 3);
  }
  var best = v[0];
  var largest = a[0][0];
  for (var k = 1; k < 4; k++) {
    if (a[k][k] > largest) {
      largest = a[k][k];
      best = v[k];
    }
  }
  best /= length(best);
  let w = best.x;
  let u = best.yzw;
  return scaled_identity(w * w - dot(u, u)) + 2.0 * outer_product(u, u) +
         2.0 * w * mat3x3f(0.0, u.z, -u.y, -u.z, 0.0, u.x, u.y, -u.x, 0.0);
}

// σ = 2 µ ε + λ tr ε
fn hooke(law : SolidLaw, strain : mat3x3f) -> mat3x3f {
  return (2.0 * law.mu) * strain + scaled_identity(law.lambda * (strain[0].x + strain[1].y + strain[2].z));
}

// How much Green's strain grows where F changes from `start` by `change`: the difference keeps digits that those of
// strains have lost.
fn green_change(start : mat3x3f, f : mat3x3f, change : mat3x3f) -> mat3x3f {
  let half = transpose(start + f) * change;
  return 0.25 * (half + transpose(half));
}

// The first Piola-Kirchhoff stress, Pa; of a corotated body by its rotation.
fn tet_stress(law : SolidLaw, f : mat3x3f, rotation : mat3x3f) -> mat3x3f {
  if (law.energy == kTetNeoHookean) {
    let grown = dot(f[0], cross(f[1], f[2])) - 1.0;
    return law.mu * f + ((law.lambda + law.mu) * grown - law.mu) * cofactor(f);
  }
  return (2.0 * law.mu) * (f - rotation) + (law.lambda * (contraction(rotation, f) - 3.0)) * rotation;
}

fn rotation_of(law : SolidLaw, f : mat3x3f) -> mat3x3f {
  if (law.energy == kTetNeoHookean) { return scaled_identity(1.0); }
  return nearest_rotation(f);
}

// What damping adds where F changes at a rate, Pa.
fn tet_damping_stress(law : SolidLaw, f : mat3x3f, rate : mat3x3f) -> mat3x3f {
  let half = transpose(f) * rate;
  return law.delay * (f * hooke(law, 0.5 * (half + transpose(half))));
}

// Of a stress on the corners, N.
struct TetForces {
  a : vec4f,
  b : vec4f,
  c : vec4f,
  d : vec4f,
}
fn tet_forces(rest : TetRest, stress : mat3x3f) -> TetForces {
  let b = -rest.volume * (stress * rest.b);
  let c = -rest.volume * (stress * rest.c);
  let d = -rest.volume * (stress * rest.d);
  return TetForces(vec4f(-(b + c + d), 0.0), vec4f(b, 0.0), vec4f(c, 0.0), vec4f(d, 0.0));
}
