// How the matrix of an implicit substep holds features of one cloth apart: one for each record of a near pair. Mirror:
// PairHold in src/state/contact_pairs.hpp. Names and equations: docs/solvers/multigrid.md, Contact.
#include "state/contact.wgsl"
struct PairHold {
  ids : vec4u,     // of the pair
  normal : vec4f,  // n; w: k, N/m, first 1: the pair comes near; 0: it is not held
  along : vec4f,   // τ, N; w: k_t, N/m, 0: it slides
  force : vec4f,   // λ, N; g and z, m; μ
  place : vec4f,   // s, t: weights_of; W, 1/kg; 1/C, N/m, first the gap that is missing, m
  start : vec4f,   // Σ w (the way to z, and d₀), m; w: g of the velocities at the start of the substep, m, first the
                   // thickness, m
}

// Sums over a vertex's held pairs, of integers, since pairs have no order: how many hold it, |w| each, in kHeldUnits;
// and a vector of three numbers of 64 bits, low word first, in kSumUnits: forces over the vertex's inertia, m, or
// changes of velocity, m/s. A value of cloth is some 10 at most; of light bodies that heavy stiff ones press, 10^5 in
// some iterations, and what was cut there would be no linear system any more. A sum of 2^7 of the largest does not pass
// over the end. The last word of a vertex is 1 where a pair with another body has held it.
const kSumWords = 8u;
const kOfOtherWord = 7u;
const kHeldUnits = 65536.0;  // 2^16
const kSumUnits = 137438953472.0;  // 2^37
const kMostSum = 524288.0;
fn sum_word(vertex : u32) -> u32 { return kSumWords * vertex + 1u; }
