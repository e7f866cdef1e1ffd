// The eigenvectors of a symmetric matrix by Jacobi's rotations, in double: Golub and Van Loan, Matrix Computations.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "base/mat3.hpp"

namespace weft::tet {

template <std::size_t N>
using Square = std::array<std::array<double, N>, N>;

/// Sets a[p][q] to zero, and turns the columns of v with it.
template <std::size_t N>
void rotate(Square<N>& a, Square<N>& v, std::size_t p, std::size_t q) {
  if (a[p][q] == 0) return;
  const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  for (std::size_t k = 0; k < N; ++k) {
    const double kp = a[k][p], kq = a[k][q];
    a[k][p] = c * kp - s * kq;
    a[k][q] = s * kp + c * kq;
  }
  for (std::size_t k = 0; k < N; ++k) {
    const double pk = a[p][k], qk = a[q][k];
    a[p][k] = c * pk - s * qk;
    a[q][k] = s * pk + c * qk;
  }
  for (std::size_t k = 0; k < N; ++k) {
    const double kp = v[k][p], kq = v[k][q];
    v[k][p] = c * kp - s * kq;
    v[k][q] = s * kp + c * kq;
  }
}

/// Makes a symmetric matrix diagonal. Returns its eigenvectors, in columns.
template <std::size_t N>
Square<N> diagonalise(Square<N>& a) {
  constexpr int kSweeps = 8;  // each doubles the digits from the third or so on
  Square<N> v{};
  for (std::size_t k = 0; k < N; ++k) v[k][k] = 1;
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (std::size_t p = 0; p + 1 < N; ++p)
      for (std::size_t q = p + 1; q < N; ++q) rotate<N>(a, v, p, q);
  return v;
}

inline Square<3> square_of(const Mat3& a) {
  return {{{a.x.x, a.x.y, a.x.z}, {a.y.x, a.y.y, a.y.z}, {a.z.x, a.z.y, a.z.z}}};
}
inline Mat3 matrix_of(const Square<3>& a) {
  return {{a[0][0], a[0][1], a[0][2]}, {a[1][0], a[1][1], a[1][2]}, {a[2][0], a[2][1], a[2][2]}};
}

/// The eigenvectors of a symmetric matrix as columns, which turn and do not mirror, and its eigenvalues.
struct Principal {
  Mat3 axes;
  std::array<double, 3> values{};
};
inline Principal principal(const Mat3& symmetric) {
  Square<3> a = square_of(symmetric);
  const Square<3> v = diagonalise(a);
  return {matrix_of(v), {a[0][0], a[1][1], a[2][2]}};
}

}  // namespace weft::tet
