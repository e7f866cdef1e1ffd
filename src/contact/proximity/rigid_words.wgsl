// The words of each collider in `rigid`, as bits of f32 but where it says u32. Those of one that is no rigid body have
// its shape alone. Mirror: src/contact/proximity/rigid_bodies.hpp. Source: docs/rigid.md.
const kRigidWords = 160u;
// The state, which lasts.
const kRigidPlace = 0u;     // of the centre of mass, m
const kRigidTurn = 4u;      // unit quaternion from its own axes
const kRigidVelocity = 8u;  // m/s
const kRigidMomentum = 12u; // angular, kg m²/s
const kRigidPush = 16u;     // by which its next way is another than its velocity's, m/s
const kRigidPushTurn = 20u; // rad/s
const kRigidLift = 24u;     // the impulse of cloth when it last bore it, N·s; 0: none lies at it
const kRigidLack = 27u;     // by how much that cloth is too near, m
// What it is.
const kRigidKind = 32u;         // u32: the kinds below
const kRigidInverseMass = 33u;  // 1/kg; 0: it is none
const kRigidExtent = 34u;       // m
const kRigidFriction = 35u;     // negative: it gives none
const kRigidHalf = 36u;         // m
const kRigidRadius = 39u;       // m
const kRigidInertia = 40u;      // kg m²
const kRigidMass = 43u;         // kg
const kRigidCenter = 44u;       // where the scene puts it, m
const kRigidFirst = 47u;        // u32: of `hulls`, its first corner; then its faces, and its edges, of two vectors each
const kRigidAxes = 48u;         // where the scene puts it, quaternion
const kRigidCorners = 52u;      // u32
const kRigidFaces = 53u;        // u32
const kRigidEdges = 54u;        // u32
// In a substep.
const kRigidNext = 64u;       // where its way ends, m
const kRigidNextTurn = 68u;
const kRigidInverse = 72u;    // R' I⁻¹ R'ᵀ: xx, yy, zz, xy, xz, yz, 1/(kg m²)
const kRigidFree = 80u;       // velocity before cloth's impulses, m/s
const kRigidFreeSpin = 84u;   // rad/s
const kRigidGiven = 88u;      // impulses of cloth so far, N·s
const kRigidGivenTurn = 92u;  // about its centre where its way ends, N·m·s
const kRigidShares = 96u;     // u32: the sum of the urgencies of its pairs
const kRigidTouches = 97u;    // u32: what it touches
const kRigidSums = 98u;       // six numbers of 64 bits: impulses that come, linear and angular
const kRigidPushes = 110u;    // likewise, of pushes
const kRigidNear = 122u;      // u32: the bits of 2 h less the gap of what bears it, the largest; 0: nothing does
const kRigidRows = 128u;      // where it is drawn: three rows of a rigid transform

const kLifts = 0.5;  // the cosine to a direction from which on cloth bears a body that way
fn lifts(lift : vec3f, direction : vec3f) -> bool { return dot(lift, direction) > kLifts * length(lift); }

const kBall = 0u;
const kCapsule = 1u;
const kBox = 2u;
const kHull = 3u;
const kPlane = 4u;
const kMesh = 5u;  // rigid bodies do not meet it

// Of sums, in a metre a second of the body: impulses by its mass, angular ones by that and its extent. A sum stays
// below 2^23 m/s, as one of 2^16 pairs of at most 2^6 m/s each does.
const kRigidUnits = 0x1p40;
const kMostRigid = 64.0;
