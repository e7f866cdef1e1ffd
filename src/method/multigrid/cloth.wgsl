// The nodes of a cycle's cloths, which are equal, and the vectors that each level of a cloth's hierarchy has.
struct ClothNodes {  // mirror: src/method/multigrid/cycle.hpp
  first_vertex : u32,  // where those of the first cloth begin among the vertices; the others follow
  count : u32,
  residual : f32,   // what its linear system may leave of the residual: squared, of the norm
  may_retry : u32,  // 1: a frame whose system is not solved in the iterations recorded is run again with more
  vectors : u32,    // of a cloth, in vec4f
  iterations : u32,  // recorded, of the last system
  first_part : f32,  // how much more the first may leave: squared
  padding : u32,
}

// The cloth that an invocation works on, along z of the dispatch: its kernel sets it.
var<private> cloth : u32;

// The vectors of a level in the buffer `vectors`: node after node, one vector after the other.
const kResidual = 0u;   // N; of the finest level: first the residual of inertia
const kInverse = 1u;    // m/N: inverse of the diagonal's block: xx, yy, zz, yz; in the next: xz, xy
const kDirection = 3u;  // m: the last smoothing sweep; between: the residual that is handed down, N
const kFirst = 4u;      // m: the solution; of the finest level: first the step's start
const kSecond = 5u;     // m: the solution, while smoothing; of the finest level: first the start's velocity, m/s
const kVectors = 6u;
// Further ones of the finest level: those of conjugate gradients.
const kSolution = 6u;   // m
const kSearch = 7u;     // m: p of this iteration, and in the next vector that of the last, in turns
const kProduct = 9u;    // N: A p
const kWay = 10u;       // m: from where the substep begins to where the unknown starts; w, of a free node: 1 in the
                        // second of two systems, 0 in the first
const kAir = 11u;       // N/m: where the air pushes, its block of the matrix, as kInverse and the next
