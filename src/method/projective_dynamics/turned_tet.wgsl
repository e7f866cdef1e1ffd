// A tetrahedron as a cycle begins: the rotation R that is nearest to it, and how fast its stress grows with a change X
// of F while R stays, across X + along (R : X) R. Source: docs/solvers/projective_dynamics.md, Bodies.
struct TurnedTet {  // mirror: src/method/projective_dynamics/relaxed_solid.hpp
  first : vec4f,   // the rotation's columns; w: across, Pa
  second : vec4f,  // w: along, Pa
  third : vec4f,   // w: unused
}
