// Keeps a node's blocks of a coarse level's matrix, as coarse_block.wgsl reads them. The including kernel binds `operators`.
#include "multigrid/level.wgsl"
#include "multigrid/symmetric.wgsl"

fn store_blocks(level : Level, node : u32, b : array<Symmetric, 5>) {
  operators[operator_at(level, 0u, node)] = vec4f(b[0].diagonal, b[0].mixed.x);
  operators[operator_at(level, 1u, node)] = vec4f(b[1].diagonal, b[1].mixed.x);
  operators[operator_at(level, 2u, node)] = vec4f(b[2].diagonal, b[2].mixed.x);
  operators[operator_at(level, 3u, node)] = vec4f(b[3].diagonal, b[3].mixed.x);
  operators[operator_at(level, 4u, node)] = vec4f(b[4].diagonal, b[4].mixed.x);
  operators[operator_at(level, 5u, node)] = vec4f(b[0].mixed.yz, b[1].mixed.yz);
  operators[operator_at(level, 6u, node)] = vec4f(b[2].mixed.yz, b[3].mixed.yz);
  operators[operator_at(level, 7u, node)] = vec4f(b[4].mixed.yz, 0.0, 0.0);
}
