// The nodes of one colour, and their elements, in `lists`: nodes by colours, then rows of nodes and their entries.
struct GatheredColor {  // mirror: src/method/vbd/gathered_color.hpp
  first : u32,       // in `lists`
  count : u32,
  first_node : u32,  // of the body
  rows : u32,        // where in `lists` its nodes' rows begin, and with that their entries
}
