// What a cloth resists with, as a sheet: of fabric its moduli, of springs those of the even sheet that they make.
#pragma once

#include "element/orthotropic.hpp"
#include "model/model.hpp"

namespace weft {

struct SheetModuli {
  Moduli stretch;  // [N/m]; warp: along i of a grid
  Moduli bending;  // [N·m], of slight folds
};

/// Of springs by Cauchy and Born's rule, as if all nodes moved evenly: C_ijkl = Σ k l² n_i n_j n_k n_l / A.
/// - A grid: over one cell. Every node of a lattice is where its neighbours mirror each other, so even strain is at
///   rest, and the moduli are exact but for the rows at the boundary.
/// - A mesh: over all of it, as a mean over directions. Nodes that may move otherwise give way, so these moduli are
///   never below the sheet's own.
/// Bending is 0 where only springs resist it, since slight folds do not stretch them.
/// Source: docs/elements.md, Moduli of springs.
SheetModuli sheet_moduli(const Model& model, const Body& body);

/// The least height of a triangle of the cloth [m].
double least_height(const Model& model, const Body& body);

}  // namespace weft
