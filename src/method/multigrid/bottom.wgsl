// Smoothing on the coarsest level: it has nothing below it that could take the low eigenvalues, so more steps, for a wider range.
#include "method/multigrid/chebyshev.wgsl"
const kBottomLow = kHigh / 30.0;
const kBottomSteps = 10u;
