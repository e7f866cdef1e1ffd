#include "method/xpbd/plan.hpp"

#include "method/projection/row.hpp"

namespace weft {

Method xpbd_method() {
  Method row = projection_row(scene::SolverKind::Xpbd);
  row.memory = [](const scene::Solver&) {
    return SolverMemory{160, 72};
  };  // 16 and 12 bytes a spring; of the rest 64 with obstacles alone
  row.blow_part = 0.0007;
  return row;
}

}  // namespace weft
