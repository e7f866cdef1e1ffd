// Real-time cloth: all of the public interface. docs/cpp.md is its guide.
//
// Units are SI. Sizes are checked, and every failure is a Result; no function throws. Headers need C++20 and nothing
// but the standard library.
#pragma once

#if __cplusplus < 202002L
#error "weft's headers need C++20: compile with -std=c++20 or a later standard."
#endif

#include "weft/adapter.hpp"
#include "weft/image.hpp"
#include "weft/placement.hpp"
#include "weft/report.hpp"
#include "weft/result.hpp"
#include "weft/scene.hpp"
#include "weft/totals.hpp"
#include "weft/vec.hpp"
#include "weft/view.hpp"
#include "weft/world.hpp"
