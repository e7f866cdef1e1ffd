#pragma once

#include <functional>

namespace weft {

/// Has `job` done after the last test: what must not be left to static destructors, as drivers have some of their own.
void at_end(std::function<void()> job);

}  // namespace weft
