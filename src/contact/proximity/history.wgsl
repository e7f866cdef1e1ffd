// The velocities of vertices, for a kernel that marks some as without a history: several invocations write the same
// word. The including kernel binds `velocity` as array<atomic<u32>>, 4 * vertex_count, the bits of f32.
fn velocity_of(vertex : u32) -> vec3f {
  return bitcast<vec3f>(vec3u(atomicLoad(&velocity[4u * vertex]), atomicLoad(&velocity[4u * vertex + 1u]),
                              atomicLoad(&velocity[4u * vertex + 2u])));
}
override kForgets : bool = true;  // false: the solver's formula is the same for what is pressed
fn forget_history(vertex : u32) {
  if (kForgets) { atomicStore(&velocity[4u * vertex + 3u], 0u); }
}
