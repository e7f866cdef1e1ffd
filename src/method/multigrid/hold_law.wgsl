// The numbers of equations 11 and 16 of docs/solvers/multigrid.md. Mirror: contact/rules/contact_law.hpp,
// method/multigrid/reference/hold.hpp and pair_hold.hpp.
#include "contact/proximity/hold_rule.wgsl"
// Along the normal, of the inertia of what an obstacle holds, or of a body's node the geometric mean of that and of its
// block of the matrix; across it, of the inertia: 1.
const kHoldStiffness = 30.0;
const kPairStiffness = 2.0;   // the same of a pair of one cloth
// What the first system leaves of such a pair's gap, or thickness: with less, the second holds it by the stiffness of
// its cloth.
const kCloses = 0.5;
// What the spring stops alone, where nothing else holds a node, is a blow, and over, beyond what the node has borne:
// kept as a load it would throw the node up again. The least part that is kept, so that the next substep knows that the
// node bears.
const kLanded = 1e-5;
// The most by which a velocity changes for what acted beyond what counts, by the speed over the surface: that of what
// slips, in backward Euler. A node that lands, whose substep is of BDF2, would turn around, and springs that let go
// would give far more than it can take.
const kMostFreed = 1.0;
