#include "element/hinge/plate.hpp"

#include <algorithm>

#include "element/hinge/creases.hpp"
#include "element/hinge/parts.hpp"

namespace weft::hinge {
namespace {

/// Adds what a facet has in a hinge's row of the matrix of moments.
void add_row(const Plate& plate, const Facet& facet, std::uint32_t hinge, std::vector<Coupling>& row) {
  const std::array<Part, 3> parts = parts_of(plate, facet);
  const Vec3d by_part = facet.stiffness * weights_in(parts, hinge);  // which is symmetric
  for (int j = 0; j < 3; ++j)
    for (std::size_t l = 0; l < 5; ++l) {
      const Part& part = parts[static_cast<std::size_t>(j)];
      const double entry = by_part[j] * part.weights[l];
      if (entry == 0) continue;
      const auto found =
          std::find_if(row.begin(), row.end(), [&](const Coupling& c) { return c.column == part.hinges[l]; });
      if (found == row.end())
        row.push_back({hinge, part.hinges[l], entry});
      else
        found->entry += entry;
    }
}

/// A facet's parts of angles as linear forms of places, for small bends of a plane sheet: rows over its nodes.
struct FlatForms {
  std::vector<std::uint32_t> nodes;
  std::array<std::vector<double>, 3> weights;

  FlatForms(const Plate& plate, const Facet& facet, std::span<const Vec3d> rest) {
    const std::array<Part, 3> parts = parts_of(plate, facet);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 5; ++k) {
        if (parts[i].weights[k] == 0) continue;
        const Hinge& hinge = plate.hinges[parts[i].hinges[k]];
        const std::array<double, 4> slope = flat_slope(corners_of(hinge, rest));
        for (std::size_t n = 0; n < 4; ++n)
          weights[i][place_of(hinge.nodes[n])] += parts[i].weights[k] * slope[n];
      }
  }

 private:
  std::size_t place_of(std::uint32_t node) {
    const auto found = std::find(nodes.begin(), nodes.end(), node);
    if (found != nodes.end()) return static_cast<std::size_t>(found - nodes.begin());
    nodes.push_back(node);
    for (std::vector<double>& row : weights) row.push_back(0);
    return nodes.size() - 1;
  }
};

}  // namespace

std::vector<double> bends(const Plate& plate, std::span<const Vec3d> position) {
  std::vector<double> all;
  all.reserve(plate.hinges.size());
  for (const Hinge& hinge : plate.hinges)
    all.push_back(angle(corners_of(hinge, position)) - hinge.rest_angle);
  return all;
}

std::vector<double> bend_rates(const Plate& plate, std::span<const Vec3d> position,
                               std::span<const Vec3d> velocity) {
  std::vector<double> all;
  all.reserve(plate.hinges.size());
  for (const Hinge& hinge : plate.hinges) {
    const Corners slope = angle_slope(corners_of(hinge, position)), speed = corners_of(hinge, velocity);
    double rate = 0;
    for (std::size_t i = 0; i < 4; ++i) rate += dot(slope[i], speed[i]);
    all.push_back(rate);
  }
  return all;
}

double energy(const Plate& plate, std::span<const double> bends, std::span<const Crease> creases) {
  double sum = 0;
  if (bends.empty()) return sum;
  for (std::size_t f = 0; f < plate.facets.size(); ++f) {
    const Facet& facet = plate.facets[f];
    Vec3d angles = angles_of(parts_of(plate, facet), bends);
    if (!creases.empty()) angles += -1.0 * creases[f].parts;
    sum += dot(angles, facet.stiffness * angles) / 2;
  }
  return sum;
}

std::vector<double> moments(const Plate& plate, std::span<const double> bends,
                            std::span<const Crease> creases) {
  std::vector<double> all(bends.size());
  if (bends.empty()) return all;
  for (std::size_t f = 0; f < plate.facets.size(); ++f) {
    const Facet& facet = plate.facets[f];
    const std::array<Part, 3> parts = parts_of(plate, facet);
    Vec3d angles = angles_of(parts, bends);
    if (!creases.empty()) angles += -1.0 * creases[f].parts;
    const Vec3d by_angle = facet.stiffness * angles;
    for (int i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 5; ++k) {
        const Part& part = parts[static_cast<std::size_t>(i)];
        all[part.hinges[k]] += part.weights[k] * by_angle[i];
      }
  }
  return all;
}

void add_forces(const Plate& plate, std::span<const double> moments, std::span<const Vec3d> position,
                std::span<Vec3d> force) {
  for (std::size_t h = 0; h < plate.hinges.size(); ++h) {
    const Corners slope = angle_slope(corners_of(plate.hinges[h], position));
    for (std::size_t i = 0; i < 4; ++i) force[plate.hinges[h].nodes[i]] -= moments[h] * slope[i];
  }
}

std::vector<Coupling> couplings(const Plate& plate) {
  std::vector<Coupling> all, row;
  for (std::uint32_t h = 0; h < plate.hinges.size(); ++h) {
    row.clear();
    for (const std::uint32_t facet : facets_of(plate, h)) add_row(plate, plate.facets[facet], h, row);
    std::sort(row.begin(), row.end(),
              [](const Coupling& a, const Coupling& b) { return a.column < b.column; });
    all.insert(all.end(), row.begin(), row.end());
  }
  return all;
}

std::vector<double> stiffness_bounds(const Plate& plate) {
  std::vector<double> sums(plate.hinges.size());
  for (const Coupling& c : couplings(plate)) sums[c.row] += std::abs(c.entry);
  return sums;
}

std::vector<Coupling> isometric_matrix(const Plate& plate, std::span<const Vec3d> rest) {
  std::vector<Coupling> all;
  for (const Facet& facet : plate.facets) {
    const FlatForms forms(plate, facet, rest);
    for (std::size_t a = 0; a < forms.nodes.size(); ++a) {
      const Vec3d at_a{forms.weights[0][a], forms.weights[1][a], forms.weights[2][a]};
      const Vec3d moment = facet.stiffness * at_a;  // which is symmetric
      for (std::size_t b = 0; b < forms.nodes.size(); ++b) {
        const Vec3d at_b{forms.weights[0][b], forms.weights[1][b], forms.weights[2][b]};
        all.push_back({forms.nodes[a], forms.nodes[b], dot(moment, at_b)});
      }
    }
  }
  return all;
}

}  // namespace weft::hinge
