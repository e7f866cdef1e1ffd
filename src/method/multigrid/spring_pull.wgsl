// What a spring does to a node: equations 5 and 6 of docs/solvers/multigrid.md. The including kernel binds `step`.
#include "method/multigrid/spring_block.wgsl"

struct Pull {
  force : vec3f,        // N: on the node, where both have come to place + start
  block : SpringBlock,  // N/m: what it adds to the matrix
}

// From the node to its neighbour: span, m; how much it changes by the start of the unknown, m; and by the velocity that this would be, m/s.
fn pull_of(span : vec3f, span_step : vec3f, rate_of_span : vec3f, rest_length : f32, stiffness : f32, damping : f32, rate : f32) -> Pull {
  let hessian = spring_block(span, rest_length, stiffness, 0.0);
  let tension = stiffness * (length(span) - rest_length);
  var force = tension * hessian.direction + block_times(hessian, span_step);
  if (damping > 0.0) {  // along the spring as it will be: along its direction now, of first order in the step
    let later = span + span_step;
    let square = max(dot(later, later), kShortest * kShortest);
    force += (damping * dot(later, rate_of_span) / square) * later;
  }
  return Pull(force, SpringBlock(hessian.direction, hessian.along + damping * rate, hessian.across));
}
