#include "method/fem/plan.hpp"

#include "method/implicit_row.hpp"

namespace weft {

Method fem_method() { return implicit_row(scene::SolverKind::Fem); }

}  // namespace weft
