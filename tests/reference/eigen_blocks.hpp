// Matrices of 3 x 3 blocks in Eigen's terms.
#pragma once

#include <Eigen/Sparse>

#include "method/multigrid/reference/grid_operator.hpp"

namespace weft {

using Matrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

inline void add_block(Entries& entries, std::size_t a, std::size_t b, const Eigen::Matrix3d& block) {
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      entries.emplace_back(3 * static_cast<int>(a) + r, 3 * static_cast<int>(b) + c, block(r, c));
}

inline Matrix matrix_from(const Entries& entries, std::size_t rows, std::size_t columns) {
  Matrix matrix(3 * static_cast<int>(rows), 3 * static_cast<int>(columns));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

inline Eigen::Vector3d eigen(const Vec3d& v) { return {v.x, v.y, v.z}; }

inline Eigen::VectorXd eigen(const reference::Field& field) {
  Eigen::VectorXd all(3 * static_cast<int>(field.size()));
  for (std::size_t a = 0; a < field.size(); ++a) all.segment<3>(3 * static_cast<int>(a)) = eigen(field[a]);
  return all;
}

inline Eigen::Matrix3d dense(const reference::Sym3& s) {
  Eigen::Matrix3d block;
  block << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
  return block;
}

}  // namespace weft
