// What each cloth of a scene resists with, for people and for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "model/model.hpp"
#include "scene/scene.hpp"

namespace weft::cli {

/// Lines for each entry of `cloths`: its moduli; its largest stable explicit step, and why. Finds spectra, which takes
/// as long as a few hundred products with the matrix of a cloth.
std::string cloths_text(const scene::Scene& scene, const Model& model);

/// A list of the entries' moduli, density and friction; docs/cli.md lists the members.
nlohmann::ordered_json cloths_json(const scene::Scene& scene, const Model& model);

}  // namespace weft::cli
