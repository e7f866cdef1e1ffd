// The Hessian of a sheet's energy as a sparse matrix. Source: docs/elements.md, The reference.
#pragma once

#include <Eigen/Sparse>
#include <vector>

#include "element/reference/sheet_energy.hpp"

namespace weft::reference {

using Matrix = Eigen::SparseMatrix<double>;

/// The coordinates of free nodes, numbered.
class Unknowns {
 public:
  explicit Unknowns(const Sheet& sheet);

  int size() const { return size_; }
  int of(std::size_t node) const { return first_[node]; }  // of its x; y and z follow; held: -1
  Eigen::VectorXd gathered(std::span<const Vec3d> field) const;
  /// The field with a vector of them added.
  std::vector<Vec3d> moved(std::span<const Vec3d> field, const Eigen::VectorXd& way) const;

 private:
  std::vector<int> first_;
  int size_ = 0;
};

enum class Curvature {
  Exact,  // the second derivative of the energy
  Positive  // without what could make it indefinite: the membranes' positive part, bending's Gauss-Newton matrix
};

/// Builds matrices whose entries are in the same places at all shapes.
class SheetMatrix {
 public:
  SheetMatrix(const SheetEnergy& energy, const Unknowns& unknowns);

  /// Of the potential, by the free nodes' coordinates [N/m]. `inertia`: added to the diagonal, by mass [1/s²]. `rate`:
  /// of velocity by place, for the membranes' damping [1/s].
  Matrix hessian(Places x, Curvature curvature, double inertia = 0, double rate = 0) const;

 private:
  using Entries = std::vector<Eigen::Triplet<double>>;

  void add(Entries& entries, std::uint32_t a, std::uint32_t b, const Mat3& block) const;
  Matrix bending_matrix(Places x) const;

  const SheetEnergy& energy_;
  const Unknowns& unknowns_;
  Matrix couplings_;  // of the hinges' moments
};

}  // namespace weft::reference
