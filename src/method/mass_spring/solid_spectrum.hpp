#pragma once

#include "method/step_limit.hpp"

namespace weft {

/// The largest eigenvalues of M^-1 K and M^-1 C of a body with volume at rest, where C is its delay times K. Nodes that
/// the scene holds are free, which can only raise them.
NetworkSpectrum find_solid_spectrum(const Model& model, const Body& body);

}  // namespace weft
