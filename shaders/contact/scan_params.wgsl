// Which numbers of a buffer are summed. Mirror: ScanParams in src/collision/scan.hpp.
struct ScanParams {
  count : u32,        // of numbers
  stride : u32,       // words from one to the next
  source : u32,       // word of the first
  sums : u32,         // word of the first's sum
  first_block : u32,  // word of the first block's sum; the total follows the last block's
  capacity : u32,     // pairs that the lists have room for; 0: these numbers do not count pairs
}
