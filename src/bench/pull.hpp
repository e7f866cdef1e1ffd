#pragma once

#include <functional>
#include <span>

#include "bench/row.hpp"
#include "bench/selection.hpp"

namespace weft::bench {

/// Where the shipped scenes and the models are.
struct Folders {
  std::string scenes, models;
};

/// What a selection may ask for: "none", "bvh", "proximity", "proximity_self", "paper".
std::span<const std::string_view> pull_variants();
/// "sphere", "armadillo", "dragon".
std::span<const std::string_view> pull_objects();

/// The paper's second experiment: the pull scenes over three objects, with and without contact, over grids
/// of 64² to 800² nodes (`quick`: 32² and 64² over the sphere and the armadillo), or what is selected. Each
/// method is timed near a state to which its own contact has brought the sheet, while it is pulled at full speed and
/// two steps have hits. Brute force is left out from the first size whose step takes over 2 s. Errors  Input: a scene
/// or model is missing, or nothing is pulled. DeviceLost, Shader; what is too large for the adapter, or has no hits, is
/// a skipped row.
Result<void> run_pull(gpu::Device& device, const Selection& selection, const Folders& folders,
                      const std::function<Result<void>(const Row&)>& done);

}  // namespace weft::bench
