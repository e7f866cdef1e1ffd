#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "method/mass_spring/spring_network.hpp"
#include "method/step_limit.hpp"

namespace weft {

/// y = A x of a symmetric matrix.
using SymmetricProduct = std::function<void(const std::vector<Vec3d>& x, std::vector<Vec3d>& y)>;
/// The largest eigenvalue of A of `count` nodes, from below, by Lanczos from a seeded random start, until the estimate
/// converges. The same bits on every machine. Source: Golub and Van Loan, "Matrix Computations", section 10.1.
double largest_eigenvalue(const SymmetricProduct& product, std::size_t count);

/// The largest eigenvalues of M^-1 K and M^-1 C at rest: K (stiffness) and C (damping) sum k n n^T and c n n^T over the
/// springs; K has the resistance to bending too. A = M^-1/2 K M^-1/2.
NetworkSpectrum find_spectrum(const SpringNetwork& network);

}  // namespace weft
