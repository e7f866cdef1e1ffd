// Sums over a vertex's pairs with obstacles before a substep is solved, each weighted by the vertex's part in the pair:
// of integers, since pairs have no order. `press` writes them, `gradient` reads them.
//
// How many pairs a vertex has is not known beforehand: coarse cloth on a fine mesh has thousands. So a sum has two
// words: its lowest 32 bits as an i32, and how often that has passed over either end, + 2^32 each. No addend is
// beyond kMost = 64 units of 2^20 = 2^26, and no list has 2^32 pairs, so a sum stays below 2^58, and the second word
// below 2^27. Both are the same in any order: the lowest bits do not depend on it, so neither does what is left.
//
// Before the sums of all vertices stand four words of each: the force that holds it, which stays from substep to
// substep, τ and λ, N, as the bits of f32; or kUnderCloth for λ, where that held it and cloth lies on it. The including
// kernel binds `step`.
const kHoldWords = 4u;
const kHoldNormal = 3u;  // which of them is λ
const kUnderCloth = -1.0;
const kPressWords = 20u;
const kPressNormal = 0u;    // three: the direction that they press in; kPressUnits
const kPressLack = 3u;      // how far along it the vertex has to go beyond its velocity; kLackUnits in a thickness
const kPressWeight = 4u;    // kPressUnits
const kPressSurface = 5u;   // three: the obstacle's velocity, m/s; kPressUnits
const kPressFriction = 8u;  // kPressUnits
const kPressRestored = 9u;  // the part of that lack by which the vertex is too near; kLackUnits in a thickness
const kPressWraps = 10u;    // from a sum's first word to its second
const kPressUnits = 1048576.0;  // 2^20
const kLackUnits = 1048576.0;
const kMostLack = 16.0;     // thicknesses
const kMostSurface = 64.0;  // m/s
const kMostFriction = 64.0;

// Where the sums of a vertex begin.
fn press_words(vertex : u32) -> u32 { return kHoldWords * step.nodes.count + kPressWords * vertex; }
