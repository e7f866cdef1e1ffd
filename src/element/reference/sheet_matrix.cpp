#include "element/reference/sheet_matrix.hpp"

#include "element/hinge/angle_hessian.hpp"

namespace weft::reference {

Unknowns::Unknowns(const Sheet& sheet) {
  for (std::size_t v = 0; v < sheet.rest.size(); ++v) {
    first_.push_back(sheet.is_held(v) ? -1 : size_);
    if (!sheet.is_held(v)) size_ += 3;
  }
}

Eigen::VectorXd Unknowns::gathered(std::span<const Vec3d> field) const {
  Eigen::VectorXd all(size_);
  for (std::size_t v = 0; v < field.size(); ++v)
    if (first_[v] >= 0) all.segment<3>(first_[v]) << field[v].x, field[v].y, field[v].z;
  return all;
}

std::vector<Vec3d> Unknowns::moved(std::span<const Vec3d> field, const Eigen::VectorXd& way) const {
  std::vector<Vec3d> all(field.begin(), field.end());
  for (std::size_t v = 0; v < field.size(); ++v)
    if (first_[v] >= 0) all[v] += Vec3d{way(first_[v]), way(first_[v] + 1), way(first_[v] + 2)};
  return all;
}

SheetMatrix::SheetMatrix(const SheetEnergy& energy, const Unknowns& unknowns)
    : energy_(energy), unknowns_(unknowns) {
  Entries entries;
  for (const hinge::Coupling& c : hinge::couplings(energy.plate()))
    entries.emplace_back(static_cast<int>(c.row), static_cast<int>(c.column), c.entry);
  const auto hinges = static_cast<int>(energy.plate().hinges.size());
  couplings_.resize(hinges, hinges);
  couplings_.setFromTriplets(entries.begin(), entries.end());
}

void SheetMatrix::add(Entries& entries, std::uint32_t a, std::uint32_t b, const Mat3& block) const {
  const int row = unknowns_.of(a), column = unknowns_.of(b);
  if (row < 0 || column < 0) return;
  const std::array rows = {block.x, block.y, block.z};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      entries.emplace_back(row + r, column + c, rows[static_cast<std::size_t>(r)][c]);
}

Matrix SheetMatrix::hessian(Places x, Curvature curvature, double inertia, double rate) const {
  const membrane::Law& law = energy_.sheet().membrane;
  const auto& triangles = energy_.sheet().triangles;
  const bool exact = curvature == Curvature::Exact, damped = law.delay > 0 && rate > 0;
  Entries entries;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const membrane::Axes f = energy_.membranes().deformation(t, x);
    const membrane::Rest& rest = energy_.membranes().rests[t];
    const auto own = blocks(rest, exact ? membrane::hessian(law, f) : positive_hessian(law, f));
    const auto damping = damped ? blocks(rest, damping_hessian(law, f)) : membrane::Blocks{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        add(entries, triangles[t][i], triangles[t][j], own[i][j] + rate * damping[i][j]);
  }
  if (exact) {
    const hinge::Plate& plate = energy_.plate();
    const std::vector<double> moments = hinge::moments(plate, hinge::bends(plate, x));
    for (std::size_t h = 0; h < plate.hinges.size(); ++h) {
      const auto& nodes = plate.hinges[h].nodes;
      const auto change = hinge::angle_hessian(hinge::corners_of(plate.hinges[h], x));
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) add(entries, nodes[i], nodes[j], moments[h] * change[i][j]);
    }
  }
  for (std::uint32_t v = 0; v < x.size(); ++v)
    add(entries, v, v, Mat3::identity(inertia * energy_.mass()[v]));
  Matrix all(unknowns_.size(), unknowns_.size());
  all.setFromTriplets(entries.begin(), entries.end());
  return all + bending_matrix(x);
}

/// By Gauss and Newton: the moments' matrix between the slopes of the angles.
Matrix SheetMatrix::bending_matrix(Places x) const {
  Entries entries;
  const hinge::Plate& plate = energy_.plate();
  for (std::size_t h = 0; h < plate.hinges.size(); ++h) {
    const auto& nodes = plate.hinges[h].nodes;
    const hinge::Corners slope = hinge::angle_slope(hinge::corners_of(plate.hinges[h], x));
    for (std::size_t i = 0; i < 4; ++i)
      for (int axis = 0; axis < 3; ++axis)
        if (const int column = unknowns_.of(nodes[i]); column >= 0)
          entries.emplace_back(static_cast<int>(h), column + axis, slope[i][axis]);
  }
  Matrix slopes(static_cast<int>(plate.hinges.size()), unknowns_.size());
  slopes.setFromTriplets(entries.begin(), entries.end());
  return slopes.transpose() * couplings_ * slopes;
}

}  // namespace weft::reference
