// A pair of features as the last search has listed it. Mirror: ListedPair in src/state/contact_pairs.hpp.
struct ListedPair {
  ids : vec4u,    // side A first, then side B; see kColliderPoint, kPairFlag, kCrossingFlag
  words : vec4u,  // kHasRecord and the record's number; before it has one, the distance that the pair keeps, m. The
                  // cloth's friction; the gap in this substep, m; kOfOneSystem to kOfTwoBodies. Of a crossing: its
                  // edge's other end, kIdBits, and how the edge has to move, in parts of the speed of equation
                  // (7). Numbers as the bits of f32.
}
const kHasRecord = 0x80000000u;

// The record of a listed pair that is near, and its measurement in this substep. Mirror: Contact in
// src/state/contact_pairs.hpp. Names and equations: docs/contact.md.
struct Contact {
  ids : vec4u,
  next : array<u32, 4>,  // links: of each cloth vertex of ids, to the record that it had before this one
  normal : vec4f,   // n, from B to A; w: the gap d, m; of what untangles: minus the part of that speed
  place : vec4f,    // s, t: where on the features (weights_of); n·p_A; n·(how far a solid side comes), m
  surface : vec4f,  // the collider's part of the relative velocity, m/s; w: friction
  force : vec4f,    // on side A, N: of this substep once the pair is answered, else of the one before; w: the least
                    // normal velocity of equation (3), m/s
  urgency : f32,    // its share of its vertices' masses, before they are shared; 0: it does not act, equation (1)
  solid : u32,      // the side that contact cannot move (collider, fixed vertex): 1 A, 2 B, 0 neither; or kUntangles
  near : u32,       // 1: it acts, or would but that another feature is nearer, or has a plane that must hold
  other_end : u32,  // of a crossing: the id of the edge's other end; else kOfOneSystem to kOfTwoBodies
  thickness : f32,  // the distance that it keeps, m
  solid_speed : f32,  // of a solid side, toward the other, m/s
  begun : f32,      // the normal part of the force that the last iteration ended with, before it went ahead, N
  held : u32,       // 1: the solver's matrix has answered it; kSolved: the same of a pair of one cloth
}
const kColliderPoint = 0x80000000u;  // of an id: a point of `points`, not a cloth vertex
const kPairFlag = 0x40000000u;       // of ids.x: edge and edge; of ids.y: vertex and shape (a plane, a ball, or from
                                     // that point to ids.z a capsule); else vertex and triangle
const kCrossingFlag = 0x40000000u;   // of ids.z: an end of an edge, and the triangle that the edge passes through
const kIdBits = 0x3fffffffu;
const kOfOneSystem = 1u;             // both features: of one cloth, or of bodies that a solver's matrix has together
const kComesOnFront = 2u;            // on that of the triangle, a vertex that is in it: docs/contact.md, equation (1b)
const kOfBodies = 4u;                // of one system: of bodies with volume
const kOfTwoBodies = 8u;             // of these, of two
const kSolved = 2u;
const kUntangles = 4u;               // of `solid`: it separates features on the wrong side, equation (7)

// A link is 4 * (number + 1) + role, 0 at the end: how a vertex knows its records, the newest first.
fn link_to(number : u32, role : u32) -> u32 { return 4u * (number + 1u) + role; }
fn record_of(link : u32) -> u32 { return link / 4u - 1u; }
fn role_of(link : u32) -> u32 { return link & 3u; }

const kPressedOften = 8;  // cloth is pressed where more than one in so many of its pairs with cloth
const kPressedGap = 0.9;  // keeps less than this part of its thickness
fn cloth_is_pressed(excess : u32) -> bool { return bitcast<i32>(excess) > 0; }  // by the word kStatPressed
const kContactTouching = 1.001;  // of the thickness: what rests there is in contact, whatever the rounding of its place

fn is_collider(id : u32) -> bool { return (id & kColliderPoint) != 0u; }
fn is_edge_pair(ids : vec4u) -> bool { return (ids.x & kPairFlag) != 0u; }
fn is_crossing(ids : vec4u) -> bool { return (ids.z & kCrossingFlag) != 0u; }
fn is_shape_pair(ids : vec4u) -> bool { return (ids.y & kPairFlag) != 0u; }
// A pair with a collider has at least one of its points in these two places.
fn is_self_pair(ids : vec4u) -> bool { return ((ids.x | ids.z | ids.y) & kColliderPoint) == 0u; }
fn is_of_two_systems(contact : Contact) -> bool {
  return is_self_pair(contact.ids) && (is_crossing(contact.ids) || (contact.other_end & kOfOneSystem) == 0u);
}
// Of a pair with a collider, the first of its points there.
fn collider_of(ids : vec4u) -> u32 {
  return select(select(ids.z, ids.x, is_collider(ids.x)), ids.y, is_shape_pair(ids));
}
// The roles that are there: a pair with a plane or a ball has two, with a capsule three.
fn role_count(ids : vec4u) -> u32 { return select(4u, select(2u, 3u, is_collider(ids.z)), is_shape_pair(ids)); }
// Roles below this are on side A.
fn roles_of_a(ids : vec4u) -> u32 { return select(1u, 2u, is_edge_pair(ids)); }

fn weights_of(ids : vec4u, s : f32, t : f32) -> vec4f {
  if (is_edge_pair(ids)) { return vec4f(1.0 - s, s, t - 1.0, -t); }
  if (is_shape_pair(ids)) { return vec4f(1.0, t - 1.0, -t, 0.0); }
  return vec4f(1.0, s + t - 1.0, -s, -t);
}

// How much of a vertex's mass a pair may use, among others that act: the more, the deeper its features will be in each
// other's thickness. In whole numbers, so that sums do not depend on their order.
const kMostUrgent = 255.0;
fn urgency_of(gap : f32, thickness : f32) -> u32 {
  let depth = clamp(1.0 - gap / thickness, 0.0, 1.0);
  return 1u + u32(kMostUrgent * depth * depth);
}

// The words of each vertex: the link to its records; then of this substep the part of its way that passes no plane
// between it and other cloth, as the inverted bits of f32, 0: all of it; the sum of its pairs' shares of its mass, in
// kShareUnits, and by how much the nearest plane of a solid side is nearer than free_way, m, as the bits of a positive
// f32; of the last search, whether it is tangled; the sums of what pairs give it, of integers, since pairs have no
// order: changes of velocity by impulses, the same by the impulses that pairs begin with, in kSpeedUnits, and pushes,
// in kPushUnits; and how it was held back, as bits.
const kVertexWords = 16u;
const kLinkWord = 0u;
const kPartWord = 1u;
const kShareWord = 2u;
const kBlowWord = kShareWord;  // before a search: how far an expected blow goes, m, as bits of f32; where: kChangeWord
const kTightWord = 3u;
const kTangledWord = 4u;
const kChangeWord = 5u;  // and two more
const kFirstWord = 8u;   // and two more
const kLostWord = kFirstWord;  // once impulses are answered: what its way has lost, m, as bits of f32
const kPushWord = 11u;   // and two more
const kHeldWord = 14u;
// Of kTangledWord: the vertex is of an edge or a triangle that passes through another, of cloth, of a mesh.
const kTangledCloth = 1u;
const kTangledMesh = 2u;
const kShareUnits = 256.0;
const kSpeedUnits = 4194304.0;  // 2^22 in a metre a second: sums stay below 512 m/s
const kPushUnits = 1073741824.0;  // 2^30 in a metre: sums stay below 2 m
const kMostUnits = 1.0e9;       // of one pair
const kMarked = 1u;  // of kHeldWord: it may meet other cloth on its way
const kHeld = 2u;    // its way ends before the planes between it and other cloth
const kCounted = 4u; // among the truncated
const kBesideSolid = 8u;  // it has a record with what contact cannot move
const kBesideCloth = 32u;  // a pair of it with another cloth acts on it
const kStruck = 64u;  // by an obstacle: a pair of it with one would end nearer than a held one may
const kFarWay = 16u;  // it goes farther than free_way: planes of obstacles without a record count, too
const kInBody = 3e38;           // in place of a plane's nearness: a pair moves the vertex out of a body

const kMostSeparations = 6u;  // rounds of a substep; mirror: src/contact/proximity/round_kernel.hpp
const kSoftLack = 0.02;      // of the thickness: of a smaller lack less is restored, in proportion to it
const kPushPart = 0.7;       // β: of a missing gap, the part that a substep restores, by a push that is in no velocity
const kHeldLack = 0.2;       // of the thickness: what a pair may lack that is left to the solver, before it is pushed
const kStruckNear = 0.5;     // of the thickness: what would end nearer to an obstacle goes along with its impulse
const kPushSpeed = 0.5;      // m/s: of a push
const kUntanglePart = 0.125;  // of the thickness: how far apart what crosses comes in a substep
const kUntangleRate = 120.0;  // thicknesses a second: the same
