#include "method/projective_dynamics/reference/solid_relaxation.hpp"

#include <algorithm>

#include "method/tet_turning.hpp"

namespace weft::reference {
namespace {

void add_stress(const SolidBody& solid, std::size_t tet, const Mat3& stress, std::vector<Vec3d>& pulls) {
  const tet::Corners own = tet::forces(solid.tets.rests[tet], stress);
  for (std::size_t k = 0; k < 4; ++k) pulls[solid.first + solid.tets.tets[tet][k]] += own[k];
}

/// F of the body's nodes at these places.
Mat3 deformation_of(const SolidBody& solid, std::size_t tet, const std::vector<Vec3d>& x) {
  return solid.tets.deformation(tet, std::span(x).subspan(solid.first, solid.count));
}

}  // namespace

void SolidRelaxation::begin(const SolidBody& solid, const Ways& ways, double dt, std::vector<Vec3d>& pulls) {
  const tet::Law& law = solid.tets.law;
  const double delays = law.delay / dt;
  turned_.resize(solid.tets.tets.size());
  for (std::size_t t = 0; t < turned_.size(); ++t) {
    const Mat3 start = deformation_of(solid, t, ways.start), f = start + deformation_of(solid, t, ways.way);
    const Mat3 rotation = tet::nearest_rotation(f);
    const Mat3 stress = tet::stress(law, f) + delays * delayed_stress(law, start, f, rotation);
    add_stress(solid, t, stress, pulls);

    const Mat3 back = transposed(rotation);
    const double own = (1 + delays) * 2 * law.mu, most = own + (1 + delays) * 3 * law.lambda;
    const double across = std::clamp(turning(symmetric_part(back * f), symmetric_part(back * stress)), own,
                                     std::max(own, most));
    turned_[t] = {rotation, across, (most - across) / 3};
  }
}

void SolidRelaxation::add_pulls_of(const SolidBody& solid, const std::vector<Vec3d>& change,
                                   std::vector<Vec3d>& pulls) const {
  for (std::size_t t = 0; t < turned_.size(); ++t) {
    const auto& [rotation, across, along] = turned_[t];
    const Mat3 f = deformation_of(solid, t, change);
    add_stress(solid, t, across * f + along * contraction(rotation, f) * rotation, pulls);
  }
}

}  // namespace weft::reference
