#pragma once

namespace weft::cli {

/// Lists the shipped scenes: name, size and title. The exit code.
int list_scenes(bool json);

}  // namespace weft::cli
