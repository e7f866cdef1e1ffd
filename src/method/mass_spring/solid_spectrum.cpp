#include "method/mass_spring/solid_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "method/mass_spring/spectrum.hpp"
#include "model/solid.hpp"

namespace weft {

/// At rest both energies are Hooke's law, and what damping does by velocities after a delay of 1 s is what they do by
/// ways.
NetworkSpectrum find_solid_spectrum(const Model& model, const Body& body) {
  tet::Tets tets = body_tets(model, body);
  tets.law.delay = 1;
  const auto rest = std::span(model.rest_position).subspan(body.first_vertex, body.vertex_count);
  const auto mass = std::span(model.mass).subspan(body.first_vertex, body.vertex_count);
  std::vector<Vec3d> way(body.vertex_count);
  const double largest = largest_eigenvalue(
      [&](const std::vector<Vec3d>& x, std::vector<Vec3d>& y) {  // y = M^-1/2 K M^-1/2 x
        for (std::size_t n = 0; n < x.size(); ++n) way[n] = x[n] / std::sqrt(mass[n]);
        std::fill(y.begin(), y.end(), Vec3d{});
        tets.add_damping_forces(rest, way, y);
        for (std::size_t n = 0; n < y.size(); ++n) y[n] = y[n] / -std::sqrt(mass[n]);
      },
      body.vertex_count);
  return {largest, body.solid->damping * largest};
}

}  // namespace weft
