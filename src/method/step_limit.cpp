#include "method/step_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "model/enclosed.hpp"

namespace weft {
namespace {

constexpr double kMostSubsteps = 65536;  // docs/scene.md, time.substeps

}  // namespace

double largest_stable_step(double stiffness, double damping) {
  // Not the difference (√(μ² + 4 λ) - μ) / λ: where μ is large it cancels to 0, and 0 means no limit.
  const double sum = std::sqrt(damping * damping + 4 * stiffness) + damping;
  return sum > 0 ? 4 / sum : 0;
}

std::string unstable_step(const StepLimit& limit, double frame, std::uint32_t substeps) {
  const double step = frame / substeps;
  if (limit.largest_step <= 0 || step <= limit.largest_step) return {};
  std::array<char, 256> text{};
  std::snprintf(
      text.data(), text.size(),
      "The step of %.3g ms is longer than the largest stable one of %.3g ms, so the cloth may blow up: "
      "%.0f substeps a frame are needed, not %u.",
      1e3 * step, 1e3 * limit.largest_step, std::ceil(frame / limit.largest_step), substeps);
  return text.data();
}

StepLimit with_gas(StepLimit limit, const Model& model, double most) {
  double stiffness = 0;
  for (const Body& body : model.bodies) stiffness = std::max(stiffness, gas_stiffness(model, body));
  if (stiffness == 0) return limit;
  limit.highest_frequency = std::sqrt(stiffness);
  limit.largest_step = most / limit.highest_frequency;
  limit.longest_auto_step = std::min(limit.longest_auto_step, kStepSafety * limit.largest_step);
  return limit;
}

StepLimit least_step_limit(std::vector<NetworkSpectrum> cloths, double drag) {
  StepLimit limit;
  for (const NetworkSpectrum& spectrum : cloths) {
    const double step = largest_stable_step(spectrum.stiffness, spectrum.damping + drag);
    if (limit.largest_step != 0 && step >= limit.largest_step) continue;
    limit.highest_frequency = std::sqrt(spectrum.stiffness);
    limit.highest_damping = spectrum.damping + drag;
    limit.largest_step = step;
  }
  limit.cloths = std::move(cloths);
  return limit;
}

Result<std::uint32_t> stable_substeps(const scene::Scene& scene, const StepLimit& limit) {
  if (limit.largest_step <= 0) return 1U;
  const double substeps = 4 * std::ceil(scene.time.frame / (kStepSafety * limit.largest_step) / 4);
  if (!(substeps <= kMostSubsteps))
    return make_error(
        ErrorKind::Limit,
        "Explicit steps need %.0f substeps a frame (largest stable step %.3g s), more than the limit of "
        "%.0f: "
        "lower stiffness, damping or resolution, raise the density, or name another solver.kind.",
        substeps, limit.largest_step, kMostSubsteps);
  return static_cast<std::uint32_t>(substeps);
}

Result<std::uint32_t> long_substeps(const scene::Scene& scene, const StepLimit& limit, double multiple) {
  const double steps =
      scene.time.frame / limit.longest_auto_step * (1 - 1e-12);  // an even number is not rounded up
  const double substeps = multiple * std::ceil(steps / multiple);
  if (!(substeps <= kMostSubsteps))
    return make_error(
        ErrorKind::Limit,
        "Steps of at most %.3g s are %.0f substeps a frame, more than the limit of %.0f: shorten "
        "time.frame, or set time.substeps.",
        limit.longest_auto_step, substeps, kMostSubsteps);
  return static_cast<std::uint32_t>(substeps);
}

}  // namespace weft
