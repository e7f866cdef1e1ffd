#include "method/xpbd/plan.hpp"

#include "method/projection/row.hpp"

namespace weft {

Method xpbd_method() {
  Method row = projection_row(scene::SolverKind::Xpbd);
  row.memory = [](const scene::Solver&) {
    return SolverMemory{96, 72};
  };  // 16 and 12 bytes a spring, six a node
  row.blow_part = 0.0007;
  return row;
}

}  // namespace weft
