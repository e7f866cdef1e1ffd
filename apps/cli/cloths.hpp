// What each cloth of a scene resists with, for people and for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "method/method.hpp"
#include "model/model.hpp"
#include "scene/scene.hpp"

namespace weft::cli {

/// Lines for each entry of `cloths`: its moduli; its largest stable explicit step, and why. Finds spectra, which takes
/// as long as a few hundred products with the matrix of a cloth.
std::string cloths_text(const scene::Scene& scene, const Model& model);

/// Where the method cannot represent a stiffness: by how many times that of the cloth's elements it resists in so many
/// substeps of a frame. Else "".
std::string stiffening_text(const scene::Scene& scene, const Model& model, const Method& method,
                            std::uint32_t substeps);

/// A line for each body that the method brings to rest late, if it is slender.
std::string creeping_text(const scene::Scene& scene, const Method& method);

/// A list of the entries' moduli, density and friction; docs/cli.md lists the members.
nlohmann::ordered_json cloths_json(const scene::Scene& scene, const Model& model);

}  // namespace weft::cli
