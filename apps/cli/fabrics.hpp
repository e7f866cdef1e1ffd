#pragma once

namespace weft::cli {

/// Prints the fabrics that scenes know by name, with the source of every number; the exit code.
int list_fabrics(bool json);

}  // namespace weft::cli
