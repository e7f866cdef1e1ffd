// The part of a cord of fabric in the matrix: kCordWords words a cord, behind those of all triangles. The
// including kernel binds `terms`.
#include "method/multigrid/membrane_term.wgsl"
const kCordWords = 2u;  // mirror: src/method/multigrid/fabric_system.cpp

fn cord_at(triangles : u32, cord : u32) -> u32 { return kTermWords * triangles + kCordWords * cord; }
