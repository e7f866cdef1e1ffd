#pragma once

#include <string>

namespace weft {

/// A file or folder of this checkout: source_path("scenes/breeze.json"). Only source_path.cpp is compiled with the
/// checkout's own path, so that the compiler cache serves the tests of every checkout.
std::string source_path(const std::string& relative);

}  // namespace weft
