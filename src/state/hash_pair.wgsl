// A hash of two numbers. Source: Pcg3d's mixing step (Jarzynski, Olano: Hash Functions for GPU Rendering, 2020), cut to
// two words. Mirror: src/state/hash_pair.hpp.
fn hash_pair(a : u32, b : u32) -> u32 {
  var h = a * 1664525u + 1013904223u;
  h = (h ^ b) * 2246822519u;
  h = (h ^ (h >> 15u)) * 3266489917u;
  h = (h ^ b) * 668265263u;
  return h ^ (h >> 16u);
}
