#pragma once

#include <span>
#include <string_view>

#include "sim/world.hpp"

namespace weft::bench {

/// How the forces of a sheet are found.
enum class Formulation { Grid, Mesh, SpringCentric, SpringBlocks };
inline constexpr Formulation kFormulations[] = {Formulation::Grid, Formulation::Mesh,
                                                Formulation::SpringCentric, Formulation::SpringBlocks};
/// As results name them.
const char* name_of(Formulation formulation);
/// As a selection names them, in the order of kFormulations: "grid", "mesh", "springs", "blocks".
std::span<const std::string_view> hanging_variants();

/// A scene, and what it would read from files.
struct Experiment {
  scene::Scene scene;
  Assets assets;
};

/// The paper's sheet of 2 m by 2 m that hangs from two corners, without contact, of `side` by `side` nodes.
/// Errors  Input: fewer than two nodes a side.
Result<Experiment> make_hanging_sheet(std::uint32_t side, Formulation formulation);

}  // namespace weft::bench
