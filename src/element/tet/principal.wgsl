// The eigenvectors of a symmetric 3 x 3 matrix by Jacobi's rotations: the same as jacobi.hpp in f32.
#include "element/tet/law.wgsl"
const kPrincipalSweeps = 4;  // of Jacobi: f32 has no more digits to win

// The eigenvectors of a symmetric matrix as columns, and its eigenvalues.
struct Principal {
  axes : mat3x3f,
  values : vec3f,
}

// Sets the entry pq of a symmetric matrix to zero, and turns the columns of v with it. Called with literals, so that
// drivers keep the matrices in registers.
fn clear_entry(a : ptr<function, mat3x3f>, v : ptr<function, mat3x3f>, p : i32, q : i32) {
  let turn = jacobi((*a)[p][p], (*a)[q][q], (*a)[q][p]);
  let s = turn.x;
  let c = turn.y;
  let column_p = (*a)[p];
  let column_q = (*a)[q];
  (*a)[p] = c * column_p - s * column_q;
  (*a)[q] = s * column_p + c * column_q;
  let row_p = vec3f((*a)[0][p], (*a)[1][p], (*a)[2][p]);
  let row_q = vec3f((*a)[0][q], (*a)[1][q], (*a)[2][q]);
  let new_p = c * row_p - s * row_q;
  let new_q = s * row_p + c * row_q;
  (*a)[0][p] = new_p.x;
  (*a)[1][p] = new_p.y;
  (*a)[2][p] = new_p.z;
  (*a)[0][q] = new_q.x;
  (*a)[1][q] = new_q.y;
  (*a)[2][q] = new_q.z;
  let axis_p = (*v)[p];
  let axis_q = (*v)[q];
  (*v)[p] = c * axis_p - s * axis_q;
  (*v)[q] = s * axis_p + c * axis_q;
}

fn principal(matrix : mat3x3f) -> Principal {
  var a = matrix;
  var v = scaled_identity(1.0);
  for (var sweep = 0; sweep < kPrincipalSweeps; sweep++) {
    clear_entry(&a, &v, 0, 1);
    clear_entry(&a, &v, 0, 2);
    clear_entry(&a, &v, 1, 2);
  }
  return Principal(v, vec3f(a[0].x, a[1].y, a[2].z));
}
