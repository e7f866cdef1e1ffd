#include <doctest/doctest.h>

#include "gpu/shader_source.hpp"
#include "model/host_model.hpp"
#include "state/statistics.hpp"
#include "state/step_params.hpp"
#include "wgsl_layout.hpp"

using namespace weft;

namespace {

std::string shader(const std::string& path) { return gpu::ShaderSource::load(path)->text; }

std::uint32_t statistic(const std::string& name) {
  const std::string text = shader("shared/statistics.wgsl");
  const std::size_t at = text.find("const " + name + " = ");
  return static_cast<std::uint32_t>(4 * std::stoul(text.substr(text.find("= ", at) + 2)));
}

}  // namespace

TEST_CASE("StepParams lies in C++ as in WGSL") {
  const WgslLayout wgsl = wgsl_layout(shader("shared/step.wgsl"), "StepParams");
  CHECK(wgsl.offset.size() == 20);
  CHECK(wgsl.offset.at("acceleration") == offsetof(StepParams, acceleration));
  CHECK(wgsl.offset.at("dt") == offsetof(StepParams, dt));
  CHECK(wgsl.offset.at("drag") == offsetof(StepParams, drag));
  CHECK(wgsl.offset.at("vertex_count") == offsetof(StepParams, vertex_count));
  CHECK(wgsl.offset.at("spring_count") == offsetof(StepParams, spring_count));
  CHECK(wgsl.offset.at("force_scale") == offsetof(StepParams, force_scale));
  CHECK(wgsl.offset.at("force_limit") == offsetof(StepParams, force_limit));
  CHECK(wgsl.offset.at("push_scale") == offsetof(StepParams, push_scale));
  CHECK(wgsl.offset.at("thickness") == offsetof(StepParams, thickness));
  CHECK(wgsl.offset.at("max_push") == offsetof(StepParams, max_push));
  CHECK(wgsl.offset.at("first_motion") == offsetof(StepParams, first_motion));
  CHECK(wgsl.offset.at("grab_rate") == offsetof(StepParams, grab_rate));
  CHECK(wgsl.offset.at("grab_speed") == offsetof(StepParams, grab_speed));
  CHECK(wgsl.offset.at("wind") == offsetof(StepParams, wind));
  CHECK(wgsl.offset.at("wind_wave_a") == offsetof(StepParams, wind_wave_a));
  CHECK(wgsl.offset.at("wind_wave_b") == offsetof(StepParams, wind_wave_b));
  CHECK(wgsl.offset.at("gust_a") == offsetof(StepParams, gust_a));
  CHECK(wgsl.offset.at("gust_b") == offsetof(StepParams, gust_b));
  CHECK(wgsl.offset.at("grab_node") == offsetof(StepParams, grab_node));
  CHECK(wgsl.offset.at("grab_target") == offsetof(StepParams, grab_target));
  CHECK(wgsl.size == offsetof(StepParams, padding));
  CHECK(wgsl_constant(shader("shared/step.wgsl"), "kMaxGrabs") == scene::kMaxGrabs);
}

TEST_CASE("Spring lies in C++ as in WGSL") {
  const WgslLayout wgsl = wgsl_layout(shader("shared/mass_spring.wgsl"), "Spring");
  CHECK(wgsl.offset.at("node_a") == offsetof(Spring, node_a));
  CHECK(wgsl.offset.at("node_b") == offsetof(Spring, node_b));
  CHECK(wgsl.offset.at("rest_length") == offsetof(Spring, rest_length));
  CHECK(wgsl.offset.at("stiffness") == offsetof(Spring, stiffness));
  CHECK(wgsl.offset.at("damping") == offsetof(Spring, damping));
  CHECK(wgsl.size == sizeof(Spring));
}

TEST_CASE("the statistics have the same places in C++ as in WGSL, and what is kept over frames comes last") {
  CHECK(statistic("kStatHits") == offsetof(Statistics, hits));
  CHECK(statistic("kStatHitHash") == offsetof(Statistics, hit_hash));
  CHECK(statistic("kStatMaxStretch") == offsetof(Statistics, max_stretch));
  CHECK(statistic("kStatContactOverflow") == offsetof(Statistics, contact_overflow));
  CHECK(statistic("kStatNonfinite") == offsetof(Statistics, nonfinite));
  CHECK(statistic("kStatFrozen") == offsetof(Statistics, frozen));
  CHECK(kStatisticsPerFrameBytes == offsetof(Statistics, nonfinite));
}
