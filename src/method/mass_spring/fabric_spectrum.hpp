#pragma once

#include "method/step_limit.hpp"

namespace weft {

/// The largest eigenvalues of M^-1 K and M^-1 C of a cloth of fabric at rest, where C is τ K: membranes and hinges of
/// the whole mesh, or of at most 64 x 64 nodes of a grid (spring_network.hpp). Nodes that the scene holds are free,
/// which can only raise them.
NetworkSpectrum find_fabric_spectrum(const Model& model, const Body& body);
/// The same of its membranes alone, or of its hinges.
NetworkSpectrum find_fabric_spectrum(const Model& model, const Body& body, ElementKind kind);

}  // namespace weft
