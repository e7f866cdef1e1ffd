#pragma once

namespace weft {

/// What of contact a solver answers itself.
struct SolvedContact {
  bool obstacles = false;
  bool pairs = false;            // of one cloth
  bool without_history = false;  // what is pressed steps without looking back (Method::history)
};

}  // namespace weft
