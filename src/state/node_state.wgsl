// One node, as a substep reads and writes it.
struct NodeState {
  position : vec4f,  // m; w: inverse mass, 1/kg
  velocity : vec4f,  // m/s
}
