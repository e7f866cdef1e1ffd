// What a frame reports to the host. Cleared before each frame but for the last two.
// Mirror: src/state/statistics.hpp. Kernels bind it as array<atomic<u32>>.
const kStatHits = 0u;            // intersecting pairs, summed over the frame's substeps
const kStatHitHash = 1u;         // wrapping sum of hash_pair over them: does not depend on their order
const kStatMaxStretch = 2u;      // largest length / rest length, as the bits of a positive f32
const kStatContactOverflow = 3u; // contacts that a list had no room for
const kStatNonfinite = 4u;       // nodes that were not finite, in all frames so far
const kStatFrozen = 5u;          // 1 once the state is frozen at the last good frame

// A hash of two numbers. Source: Pcg3d's mixing step (Jarzynski, Olano: Hash Functions for GPU Rendering, 2020), cut to two words.
fn hash_pair(a : u32, b : u32) -> u32 {
  var h = a * 1664525u + 1013904223u;
  h = (h ^ b) * 2246822519u;
  h = (h ^ (h >> 15u)) * 3266489917u;
  h = (h ^ b) * 668265263u;
  return h ^ (h >> 16u);
}
