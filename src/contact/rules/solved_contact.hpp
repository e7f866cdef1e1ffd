#pragma once

namespace weft {

/// What of contact a solver answers itself.
struct SolvedContact {
  bool obstacles = false;
  bool pairs = false;            // of one cloth
  bool without_history = false;  // what is pressed steps without looking back (Method::history)
  bool own_pairs = false;        // only its own pairs hold a vertex, not those of its edges and triangles
  bool balances = false;  // springs are in balance with it then, so impulses move no vertex in the substep
};

}  // namespace weft
