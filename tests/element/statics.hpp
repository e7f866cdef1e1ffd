// Where cloth of membranes and hinges rests under its load, by Newton's method in double.
#pragma once

#include <Eigen/Sparse>
#include <cmath>
#include <vector>

#include "element/hinge/law.hpp"
#include "element/hinge/plate.hpp"
#include "element/membrane/membranes.hpp"

namespace weft {

struct Statics {
  membrane::Membranes membranes;
  hinge::Plate plate;
  std::vector<std::uint8_t> held;
  std::vector<Vec3d> load;  // on each node [N]
  std::vector<Vec3d> x;     // [m]
  int steps = 0;            // of Newton's method, in the last call

  /// Bends by the quadratic energy from here on.
  void use_isometric_bending(const std::vector<Vec3d>& rest) {
    const auto nodes = static_cast<int>(rest.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (const hinge::Coupling& c : hinge::isometric_matrix(plate, rest))
      entries.emplace_back(static_cast<int>(c.row), static_cast<int>(c.column), c.entry);
    quadratic_.resize(nodes, nodes);
    quadratic_.setFromTriplets(entries.begin(), entries.end());
  }

  Statics(const std::vector<Vec3d>& rest, const std::vector<mesh::Triangle>& all, const membrane::Law& law,
          const Stiffness& bending, std::vector<std::uint8_t> held_nodes, const Vec3d& warp = {1, 0, 0})
      : held(std::move(held_nodes)), load(rest.size()), x(rest) {
    const RestSheet sheet{rest, all, warp, held};
    membranes = membrane::Membranes::of(sheet, law);
    plate = hinge::build_plate(sheet, bending);
    int count = 0;
    for (const std::uint8_t is_held : held) unknown_.push_back(is_held != 0 ? -1 : 3 * count++);
    size_ = 3 * count;
    for (const hinge::Coupling& c : hinge::couplings(plate))
      couplings_.emplace_back(static_cast<int>(c.row), static_cast<int>(c.column), c.entry);
  }

  double bending_energy(const std::vector<Vec3d>& place) const {
    if (quadratic_.rows() == 0) return hinge::energy(plate, hinge::bends(plate, place));
    const Eigen::MatrixX3d p = stacked(place);
    return p.cwiseProduct(quadratic_ * p).sum() / 2;
  }
  double energy_at(const std::vector<Vec3d>& place) const {
    double sum = bending_energy(place) + membranes.energy(place);
    for (std::size_t v = 0; v < place.size(); ++v) sum -= dot(load[v], place[v]);
    return sum;
  }

  std::vector<Vec3d> forces() const {
    std::vector<Vec3d> sum = load;
    membranes.add_forces(x, sum);
    if (quadratic_.rows() == 0) {
      hinge::add_forces(plate, hinge::moments(plate, hinge::bends(plate, x)), x, sum);
      return sum;
    }
    const Eigen::MatrixX3d pull = quadratic_ * stacked(x);
    for (std::size_t v = 0; v < x.size(); ++v) {
      const auto row = static_cast<int>(v);
      sum[v] -= Vec3d{pull(row, 0), pull(row, 1), pull(row, 2)};
    }
    return sum;
  }

  /// Whether every small move from here raises the energy. Of cloth that is nowhere bent.
  bool stable() const {
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factored(matrix(membrane::hessian));
    return factored.vectorD().minCoeff() > 0;
  }

  /// Until no force on a free node is above `tolerance` [N], or roundings end the fall of the energy near that.
  bool solve(double tolerance, int most = 400) {
    for (steps = 0; steps < most; ++steps) {
      const Eigen::VectorXd rest = gathered(forces());
      const double largest = rest.lpNorm<Eigen::Infinity>();
      if (largest < tolerance) return true;
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factored(matrix(membrane::positive_hessian));
      if (!go(factored.solve(rest), rest)) return largest < 100 * tolerance;
    }
    return false;
  }

 private:
  std::vector<int> unknown_;
  int size_ = 0;
  std::vector<Eigen::Triplet<double>> couplings_;
  Eigen::SparseMatrix<double> quadratic_;  // by nodes; none: bends by angles

  static Eigen::MatrixX3d stacked(const std::vector<Vec3d>& place) {
    Eigen::MatrixX3d all(place.size(), 3);
    for (std::size_t v = 0; v < place.size(); ++v)
      all.row(static_cast<int>(v)) << place[v].x, place[v].y, place[v].z;
    return all;
  }

  Eigen::VectorXd gathered(const std::vector<Vec3d>& field) const {
    Eigen::VectorXd all(size_);
    for (std::size_t v = 0; v < field.size(); ++v)
      if (unknown_[v] >= 0) all.segment<3>(unknown_[v]) << field[v].x, field[v].y, field[v].z;
    return all;
  }

  /// Bending's Gauss-Newton Hessian, or its constant one, and the membranes'.
  Eigen::SparseMatrix<double> matrix(membrane::Hessian (*hessian)(const membrane::Law&,
                                                                  const membrane::Axes&)) const {
    std::vector<Eigen::Triplet<double>> entries;
    const auto& triangles = membranes.triangles;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto own = blocks(membranes.rests[t], hessian(membranes.law, membranes.deformation(t, x)));
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) add(entries, triangles[t][i], triangles[t][j], own[i][j]);
    }
    for (int column = 0; column < quadratic_.outerSize(); ++column)
      for (Eigen::SparseMatrix<double>::InnerIterator it(quadratic_, column); it; ++it)
        add(entries, static_cast<std::uint32_t>(it.row()), static_cast<std::uint32_t>(column),
            Mat3::identity(it.value()));
    Eigen::SparseMatrix<double> all(size_, size_);
    all.setFromTriplets(entries.begin(), entries.end());
    return quadratic_.rows() == 0 ? Eigen::SparseMatrix<double>(all + hinge_matrix()) : all;
  }

  Eigen::SparseMatrix<double> hinge_matrix() const {
    std::vector<Eigen::Triplet<double>> slopes;
    for (std::size_t h = 0; h < plate.hinges.size(); ++h) {
      const auto& n = plate.hinges[h].nodes;
      const hinge::Corners slope = hinge::angle_slope(hinge::corners_of(plate.hinges[h], x));
      for (std::size_t i = 0; i < 4; ++i)
        for (int axis = 0; axis < 3; ++axis)
          if (unknown_[n[i]] >= 0)
            slopes.emplace_back(static_cast<int>(h), unknown_[n[i]] + axis, slope[i][axis]);
    }
    const auto hinges = static_cast<int>(plate.hinges.size());
    Eigen::SparseMatrix<double> slope(hinges, size_), moments(hinges, hinges);
    slope.setFromTriplets(slopes.begin(), slopes.end());
    moments.setFromTriplets(couplings_.begin(), couplings_.end());
    return slope.transpose() * moments * slope;
  }

  void add(std::vector<Eigen::Triplet<double>>& entries, std::uint32_t a, std::uint32_t b,
           const Mat3& block) const {
    if (unknown_[a] < 0 || unknown_[b] < 0) return;
    const std::array rows = {block.x, block.y, block.z};
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c)
        entries.emplace_back(unknown_[a] + r, unknown_[b] + c, rows[static_cast<std::size_t>(r)][c]);
  }

  /// As far along a way as the energy falls; false if it does not.
  bool go(const Eigen::VectorXd& way, const Eigen::VectorXd& rest) {
    const double before = energy_at(x), slope = way.dot(rest);
    for (double part = 1; part > 1e-6; part /= 2) {
      std::vector<Vec3d> place = x;
      for (std::size_t v = 0; v < x.size(); ++v)
        if (unknown_[v] >= 0)
          place[v] += part * Vec3d{way(unknown_[v]), way(unknown_[v] + 1), way(unknown_[v] + 2)};
      if (energy_at(place) > before - 1e-4 * part * slope + 1e-9 * std::abs(before))
        continue;  // its roundings
      x = place;
      return true;
    }
    return false;
  }
};

}  // namespace weft
