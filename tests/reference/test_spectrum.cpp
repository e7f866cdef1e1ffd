// The largest stable step, found without a GPU.
#include <cmath>

#include "rig.hpp"

using namespace weft;

TEST_CASE("where all springs are equally stiff, damping and stiffness have one spectrum; drag comes on top") {
  const auto simulation = simulation_of_text(R"("drag": 3, "cloths": [{"grid": [13, 17], "size": [1, 1],
    "density": 0.25, "damping": 0.02, "stiffness": {"structural": 500, "shear": 500, "bend": 500}}])");
  const StepLimit& limit = simulation.plan().limit();
  const double stiffness = limit.highest_frequency * limit.highest_frequency;
  CHECK((limit.highest_damping - 3) / 0.02 == doctest::Approx(stiffness / 500).epsilon(1e-6).scale(0));
  CHECK(limit.largest_step == doctest::Approx(largest_stable_step(stiffness, limit.highest_damping)));
}

TEST_CASE("auto takes the rule of the solvers, and a given number of substeps stands") {
  auto simulation = simulation_of_file("hanging", {{"cloths.0.grid", "[24,24]"}});
  const double least = simulation.scene().time.frame / (kStepSafety * simulation.plan().limit().largest_step);
  CHECK(simulation.substeps() % 4 == 0);
  CHECK(simulation.substeps() >= least);
  CHECK(simulation.substeps() < least + 4);
  auto given = simulation_of_file("hanging", {{"cloths.0.grid", "[8,8]"}, {"time.substeps", "37"}});
  CHECK(given.substeps() == 37);
  CHECK(given.step() == doctest::Approx(1 / (60.0 * 37)));
}
