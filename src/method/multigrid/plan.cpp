#include "method/multigrid/plan.hpp"

#include "method/implicit_row.hpp"

namespace weft {

Method multigrid_method() {
  static constexpr MethodCost kCost = {{0.45, 1.95e-6}, {0.29, 1.6e-5}, {0.6, 1.2e-5},
                                       {0.9, 2.8e-5},   {0.9, 9.3e-5},  {1.0, 2.0e-5}};
  Method row = implicit_row(scene::SolverKind::Multigrid);
  row.cost = &kCost;
  return row;
}

}  // namespace weft
