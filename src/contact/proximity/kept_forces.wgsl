// The forces of pairs that act, beyond a search, which lists pairs anew: in the buffer `kept`. It has two lists: of the
// last frame's end, with which the next frame begins, also when it is run again; and of the last search within a frame.
// kHeader words: their lengths, and the pairs that each has room for, all that may be near. Then kKeptWords a pair: its
// ids, its force, N, as the bits of f32, and 1 where the solver's matrix has given it in this substep; the list of the
// frame's end first. Then a hash table with open addressing over the list that the search reads, a power of two of
// places: a place in it is the pair's number and 1, or 0; no result depends on the order.
#include "state/contact.wgsl"
#include "state/hash_pair.wgsl"
const kHeader = 8u;
const kKeptRoomWord = 2u;  // of the header
const kKeptWords = 8u;

fn kept_word(room : u32, list : u32, number : u32) -> u32 { return kHeader + kKeptWords * (list * room + number); }
fn first_place(room : u32) -> u32 { return kept_word(room, 2u, 0u); }
fn hash_of(ids : vec4u) -> u32 { return hash_pair(hash_pair(ids.x, ids.y), hash_pair(ids.z, ids.w)); }
