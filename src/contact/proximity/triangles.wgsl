// Shared by broad and narrow phase: colliders, and pairs of triangles that may hold pairs of features.
struct SearchParams {  // mirror: src/contact/proximity/pair_search.hpp
  triangle_count : u32,      // of the cloths
  collider_count : u32,
  self_contact : u32,        // 1: cloth meets cloth
  first_row : u32,           // of `points`: four rows for each collider, its place in the world
  candidate_capacity : u32,
  pair_capacity : u32,
  thickness : f32,           // m, cloth and collider; with the reaches of both, features are listed
  self_thickness : f32,      // m, cloth and cloth
  vertex_count : u32,
  first_opposite : u32,      // of `trees`: for each cloth triangle the corners across its edges, or kNoCorner; w: its
                             // cell (patches.wgsl), a column and in the upper half a row, or kNoCell
  first_rim : u32,           // of `trees`: distance of each vertex, then point, from its sheet's rim, m; four a word
  first_rest : u32,          // of `trees`: each vertex's place at rest, m; w: the number of its cloth
  patch_columns : u32,       // of the table of patches: patches.wgsl
}
const kNoCorner = 0xffffffffu;

// A candidate: a cloth triangle and, in the upper four bits, the kind of the other; then the other's number.
const kNearCloth = 0u;      // a cloth triangle, by its place in the tree's order
const kNearRigid = 1u;      // a triangle of a rigid mesh, by its first word of `trees`
const kNearDeforming = 2u;  // a triangle of a mesh that deforms, by its place in `triangles`
const kNearSphere = 3u;     // colliders by their first point
const kNearCapsule = 4u;
const kNearPlane = 5u;
const kKindShift = 28u;
const kPlaceBits = 0x0fffffffu;

const kFrictionUnit = 7.62939453125e-06;  // 2^-17, in bits 8 to 31 of a cloth triangle's w
