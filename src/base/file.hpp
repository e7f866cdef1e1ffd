// Files read whole with a bound, and written whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace weft {

/// The bytes of a regular file.
/// Errors  Input: missing, a folder, unreadable, or over `limit` bytes.
Result<std::vector<std::byte>> read_file(const std::string& path, std::uint64_t limit);

/// Writes a file so that it is there whole or not at all: temporary name, sync, rename.
/// Errors  Failure: the folder is missing or read-only, or the disk is full.
Result<void> write_file(const std::string& path, std::span<const std::byte> bytes);
Result<void> write_file(const std::string& path, const std::string& text);

/// Makes a folder and those above it.
/// Errors  Failure: a file is in the way, or the place is read-only.
Result<void> make_folder(const std::string& path);

}  // namespace weft
