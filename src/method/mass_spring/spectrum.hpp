#pragma once

#include "method/mass_spring/spring_network.hpp"
#include "method/step_limit.hpp"

namespace weft {

/// The largest eigenvalues of M^-1 K and M^-1 C at rest, from below: K (stiffness) and C (damping) sum k n
/// n^T and c n n^T over the springs; K has the resistance to bending too. Lanczos with A = M^-1/2 K M^-1/2
/// from a seeded random start, until the estimate converges. The same bits on every machine. Source: Golub and
/// Van Loan, "Matrix Computations", section 10.1.
NetworkSpectrum find_spectrum(const SpringNetwork& network);

}  // namespace weft
