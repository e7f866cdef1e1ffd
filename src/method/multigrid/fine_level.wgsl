// Sweeps of the smoothing kernels of a grid's finest level.
#include "gpu/index.wgsl"
#include "method/multigrid/fine_bindings.wgsl"
#include "method/multigrid/fine_operator.wgsl"
#include "method/multigrid/keep_vector.wgsl"
#include "method/multigrid/operand.wgsl"
#include "method/multigrid/smoothing.wgsl"
