// Files read whole with a bound, and written whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"

namespace weft {

/// The bytes of a regular file.
/// Errors  Input: missing, a folder, unreadable, or over `limit` bytes.
Result<std::vector<std::byte>> read_file(const std::string& path, std::uint64_t limit);

/// A file that is written part by part, and is there under its name only once it is whole.
class FileWriter {
 public:
  /// Begins it under a temporary name. Errors  Failure: the folder is missing or read-only.
  static Result<FileWriter> create(const std::string& path);
  FileWriter(FileWriter&& other) noexcept
      : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)), size_(other.size_) {}
  FileWriter& operator=(FileWriter&&) = delete;
  ~FileWriter();  ///< removes what was not finished

  /// Errors  Failure: the disk is full.
  Result<void> append(std::span<const std::byte> bytes);
  /// Writes over what is there already.
  Result<void> write_at(std::uint64_t offset, std::span<const std::byte> bytes);
  std::uint64_t size() const { return size_; }
  /// Syncs it and gives it its name. Errors  Failure: the disk is full, or a folder has that name.
  Result<void> finish();

 private:
  FileWriter(std::string path, int file) : path_(std::move(path)), file_(file) {}
  std::string temporary() const;

  std::string path_;
  int file_ = -1;           // file descriptor
  std::uint64_t size_ = 0;  // bytes
};

/// Writes a file so that it is there whole or not at all: temporary name, sync, rename.
/// Errors  Failure: the folder is missing or read-only, or the disk is full.
Result<void> write_file(const std::string& path, std::span<const std::byte> bytes);
Result<void> write_file(const std::string& path, const std::string& text);

/// Makes a folder and those above it.
/// Errors  Failure: a file is in the way, or the place is read-only.
Result<void> make_folder(const std::string& path);

}  // namespace weft
