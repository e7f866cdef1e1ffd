#pragma once

#include "model/spring_network.hpp"
#include "model/step_limit.hpp"

namespace weft::reference {

/// The largest eigenvalues of M^-1 K and M^-1 C at rest, from below, as solver/mass_spring/stability.hpp
/// finds them: power iteration with A = M^-1/2 K M^-1/2 from a seeded random start.
NetworkSpectrum find_spectrum(const SpringNetwork& network, std::uint32_t iterations = 192);

/// The least of the limits of the model's cloths.
StepLimit step_limit(const HostModel& model, double drag);

}  // namespace weft::reference
