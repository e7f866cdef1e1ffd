#pragma once

#include <string>

namespace weft::cli {

/// Prints the completion script of bash, zsh or fish. The exit code.
int print_completion(const std::string& shell);

}  // namespace weft::cli
