// The laws by what they are of; validate.cpp lists them.
#pragma once

#include "validate/law.hpp"

namespace weft::validate {

// Cloth at rest: strips.cpp, bending.cpp.
Result<std::vector<Measure>> measure_stretch(const Rig& rig);
Result<std::vector<Measure>> measure_bias(const Rig& rig);
Result<std::vector<Measure>> measure_catenary(const Rig& rig);
Result<std::vector<Measure>> measure_cantilever(const Rig& rig);
Result<std::vector<Measure>> measure_standing(const Rig& rig);
Result<std::vector<Measure>> measure_refine(const Rig& rig);
Result<std::vector<Measure>> measure_twist(const Rig& rig);
Result<std::vector<Measure>> measure_lateral(const Rig& rig);

// Cloth that moves freely: motion.cpp.
Result<std::vector<Measure>> measure_fall(const Rig& rig);
Result<std::vector<Measure>> measure_chain(const Rig& rig);
Result<std::vector<Measure>> measure_pendulum(const Rig& rig);
Result<std::vector<Measure>> measure_wave(const Rig& rig);
Result<std::vector<Measure>> measure_throw(const Rig& rig);
Result<std::vector<Measure>> measure_order(const Rig& rig);

// Cloth on obstacles: friction.cpp.
Result<std::vector<Measure>> measure_slope(const Rig& rig);
Result<std::vector<Measure>> measure_landing(const Rig& rig);
Result<std::vector<Measure>> measure_capstan(const Rig& rig);

}  // namespace weft::validate
