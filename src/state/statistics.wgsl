// The report of a frame to the host. The first ten words are cleared before each frame.
// Mirror: src/state/statistics.hpp. Kernels bind it as array<atomic<u32>>.
const kStatHits = 0u;            // pairs that intersect or act, summed over the frame's substeps
const kStatHitHash = 1u;         // wrapping sum of hash_pair over them: does not depend on their order
const kStatMaxStretch = 2u;      // largest length / rest length, as the bits of a positive f32
const kStatContactOverflow = 3u; // contacts that a list had no room for
const kStatDetections = 4u;      // how often pairs were looked for
const kStatCrossings = 5u;       // edges that pass through triangles, the most that a detection has found
const kStatTruncated = 6u;       // vertices truncated by contact, summed over substeps
const kStatPairs = 7u;           // pairs that are listed, or ought to be
const kStatCandidates = 8u;      // the same of the candidate pairs of triangles
const kStatEntries = 9u;         // the same of the pairs' entries by vertex
const kStatNonfinite = 10u;      // nodes that were not finite, in all frames so far
const kStatFrozen = 11u;         // 1 once the state is frozen at the last good frame
const kStatRolledBack = 12u;     // 1 once a list was too short: no frame advances until the host makes it longer
const kStatDetect = 13u;         // 1: a vertex is about to leave its reach
const kStatDue = 14u;            // 1: a detection is under way
const kStatFound = 15u;          // crossings of this detection
const kStatReach = 16u;          // how far a collider may go until the next search, m, as the bits of a positive f32
const kStatTravel = 17u;         // how far one may have gone since this search, m, in the same form

// A hash of two numbers. Source: Pcg3d's mixing step (Jarzynski, Olano: Hash Functions for GPU Rendering, 2020), cut to
// two words.
fn hash_pair(a : u32, b : u32) -> u32 {
  var h = a * 1664525u + 1013904223u;
  h = (h ^ b) * 2246822519u;
  h = (h ^ (h >> 15u)) * 3266489917u;
  h = (h ^ b) * 668265263u;
  return h ^ (h >> 16u);
}
