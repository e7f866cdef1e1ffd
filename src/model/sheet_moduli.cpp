#include "model/sheet_moduli.hpp"

#include <algorithm>
#include <limits>

#include "model/cloth_size.hpp"

namespace weft {
namespace {

/// Moduli of strips by the inverse of C (docs/elements.md, eq. 2). An axis without stiffness takes no load.
Moduli moduli_of(const Stiffness& c) {
  const double warp = c.weft > 0 ? c.warp - c.coupled * c.coupled / c.weft : c.warp;
  const double weft = c.warp > 0 ? c.weft - c.coupled * c.coupled / c.warp : c.weft;
  return {warp, weft, c.weft > 0 ? c.coupled / c.weft : 0, c.shear};
}

/// A cell of dx by dy has a structural and a bend spring along each axis, and both its diagonals.
Moduli grid_moduli(const mesh::Grid& grid, const scene::Stiffness& k) {
  const double dx = grid.width / (grid.nx - 1), dy = grid.height / (grid.ny - 1);
  const bool long_x = grid.nx > 2, long_y = grid.ny > 2;  // else there is no spring over two cells
  const double along_x = k.structural + (long_x ? 4 * k.bend : 0);
  const double along_y = k.structural + (long_y ? 4 * k.bend : 0);
  const double diagonals = 2 * k.shear / ((dx * dx + dy * dy) * dx * dy);
  const double mixed = diagonals * dx * dx * dy * dy;
  return moduli_of({along_x * dx / dy + diagonals * dx * dx * dx * dx, mixed,
                    along_y * dy / dx + diagonals * dy * dy * dy * dy, mixed});
}

/// The mean of n_i n_j n_k n_l over directions is 3/8 for C11 and C22, 1/8 for C12 and C33.
Moduli mesh_moduli(const Model& model, const Body& body) {
  double sum = 0;
  for (const Spring spring : model.springs(body)) {
    const auto rest = static_cast<double>(spring.rest_length);
    sum += static_cast<double>(spring.stiffness) * rest * rest;
  }
  const double mean = sum / area_of(model, body);
  return moduli_of({0.375 * mean, 0.125 * mean, 0.375 * mean, 0.125 * mean});
}

}  // namespace

SheetModuli sheet_moduli(const Model& model, const Body& body) {
  if (body.fabric) {
    const scene::Fabric& fabric = *body.fabric;
    return {{fabric.warp, fabric.weft, fabric.poisson, fabric.shear},
            {fabric.bending_warp, fabric.bending_weft, 0, fabric.bending_twist}};
  }
  const double bending = body.stiffness.bending;
  return {body.grid ? grid_moduli(*body.grid, body.stiffness) : mesh_moduli(model, body),
          {bending, bending, 0, 0}};
}

double least_height(const Model& model, const Body& body) {
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < body.triangle_count; ++t) {
    const auto [a, b, c] = rest_corners(model, body, t);
    const double longest = std::max({length(b - a), length(c - b), length(a - c)});
    least = std::min(least, length(cross(b - a, c - a)) / longest);
  }
  return least;
}

}  // namespace weft
