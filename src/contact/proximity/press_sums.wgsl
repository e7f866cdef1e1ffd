// Sums over a vertex's pairs with obstacles before a substep is solved, each weighted by the vertex's part in the pair:
// of integers, since pairs have no order. `press` writes them, `gradient` reads them.
const kPressWords = 12u;
const kPressNormal = 0u;    // three: the direction that they press in; kPressUnits
const kPressLack = 3u;      // how far along it the vertex has to go beyond its velocity; kLackUnits in a thickness
const kPressWeight = 4u;    // kPressUnits
const kPressSurface = 5u;   // three: the obstacle's velocity, m/s; kPressUnits
const kPressFriction = 8u;  // kPressUnits
const kPressUnits = 1048576.0;  // 2^20
const kLackUnits = 1048576.0;
const kMostLack = 16.0;     // thicknesses
const kMostSurface = 64.0;  // m/s
const kMostFriction = 64.0;
