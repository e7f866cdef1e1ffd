// A symmetric 3 x 3 matrix: all blocks of implicit matrices are.
struct Symmetric {
  diagonal : vec3f,  // xx, yy, zz
  mixed : vec3f,     // yz, xz, xy
}

fn zero_matrix() -> Symmetric { return Symmetric(vec3f(0.0), vec3f(0.0)); }
fn identity(s : f32) -> Symmetric { return Symmetric(vec3f(s), vec3f(0.0)); }
// s n nᵀ
fn outer(n : vec3f, s : f32) -> Symmetric { return Symmetric(s * n * n, s * n.yxx * n.zzy); }
fn sum_of(a : Symmetric, b : Symmetric) -> Symmetric { return Symmetric(a.diagonal + b.diagonal, a.mixed + b.mixed); }
fn scaled(s : f32, a : Symmetric) -> Symmetric { return Symmetric(s * a.diagonal, s * a.mixed); }
// (M + Mᵀ) / 2
fn symmetric_of(m : mat3x3f) -> Symmetric {
  return Symmetric(vec3f(m[0].x, m[1].y, m[2].z),
                   0.5 * vec3f(m[1].z + m[2].y, m[0].z + m[2].x, m[0].y + m[1].x));
}
fn times(a : Symmetric, v : vec3f) -> vec3f {
  return a.diagonal * v + a.mixed.zzy * v.yxx + a.mixed.yxx * v.zzy;
}

// The inverse, of the matrix with its diagonal a little larger: f32 knows it to some 10^-7 of its largest part, and the
// smallest must stay positive. Of a matrix that is 0, 0.
const kDiagonalMargin = 4e-6;
fn inverse(matrix : Symmetric) -> Symmetric {
  let trace = matrix.diagonal.x + matrix.diagonal.y + matrix.diagonal.z;
  if (trace <= 0.0) { return zero_matrix(); }
  let d = matrix.diagonal / trace + vec3f(kDiagonalMargin);  // so that no product of three underflows
  let m = matrix.mixed / trace;
  let cofactors = Symmetric(d.yxx * d.zzy - m * m, m.yxx * m.zzy - d * m);
  let determinant = d.x * cofactors.diagonal.x + m.z * cofactors.mixed.z + m.y * cofactors.mixed.y;
  if (determinant <= 0.0) { return zero_matrix(); }
  return scaled(1.0 / (determinant * trace), cofactors);
}
