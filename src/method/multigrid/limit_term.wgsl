// The part of a limited edge of fabric in the matrix: kLimitWords words an edge, behind those of all triangles. The
// including kernel binds `terms`.
#include "method/multigrid/membrane_term.wgsl"
const kLimitWords = 2u;  // mirror: src/method/multigrid/fabric_system.cpp

fn limit_at(triangles : u32, edge : u32) -> u32 { return kTermWords * triangles + kLimitWords * edge; }
