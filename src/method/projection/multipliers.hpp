#pragma once

namespace weft {

/// What a sweep knows of those before it in the substep.
enum class Multipliers {
  Kept,       ///< what each element has pulled: sweeps end where it pulls with its stiffness (XPBD)
  Forgotten,  ///< nothing: each sweep pulls again (PBD, the form of 2007)
};

}  // namespace weft
