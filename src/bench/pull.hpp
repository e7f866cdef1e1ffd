#pragma once

#include <functional>

#include "bench/measure.hpp"

namespace weft::bench {

/// Where the shipped scenes and the models are.
struct Folders {
  std::string scenes, models;
};

/// The paper's second experiment: the pull scenes over three objects, with contact `none`, `bvh` and `paper`,
/// over grids of 64² to 800² nodes (`quick`: 32² and 64² over the sphere and the armadillo). All methods are
/// timed from the same state, 0.4 s into the scene (`quick`: 0.05 s). Brute force is left out from the first
/// size whose step takes over 2 s. Errors  Input: a scene or model is missing. DeviceLost, Shader.
Result<void> run_pull(gpu::Device& device, bool quick, const Folders& folders,
                      const std::function<Result<void>(const Row&)>& done);

}  // namespace weft::bench
