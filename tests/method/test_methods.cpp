// The rows of the methods.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "method/method.hpp"
#include "method/solver.hpp"
#include "scene/names.hpp"

using namespace weft;

TEST_CASE("every kind of solver but auto has one row that answers all that is asked of it") {
  for (std::size_t i = 0; i < std::size(scene::kSolverKindNames); ++i) {
    const auto kind = static_cast<scene::SolverKind>(i);
    CAPTURE(scene::name_of(kind));
    const auto rows = methods();
    const auto count =
        std::count_if(rows.begin(), rows.end(), [&](const Method& method) { return method.kind == kind; });
    CHECK(count == (kind == scene::SolverKind::Auto ? 0 : 1));
    if (count == 0) continue;
    const Method& method = method_of(kind);
    CHECK(!method.takes.empty());
    CHECK(static_cast<bool>(method.step_limit));
    CHECK(static_cast<bool>(method.with_drag));
    CHECK(static_cast<bool>(method.auto_substeps));
    CHECK(static_cast<bool>(method.memory));
    CHECK(static_cast<bool>(method.settings_word));
    CHECK(method.search_interval >= 1);
    CHECK(method.history <=
          1);  // State has two buffers: the state before the current one is all that is left
  }
}
