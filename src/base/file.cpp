#include "base/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace weft {
namespace {

/// Closes a file descriptor when it goes out of sight.
struct Descriptor {
  int value;
  ~Descriptor() {
    if (value >= 0) ::close(value);
  }
};

}  // namespace

Result<std::vector<std::byte>> read_file(const std::string& path, std::uint64_t limit) {
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
  if (file.value < 0) return input_error("File %s cannot be read: %s.", path.c_str(), std::strerror(errno));
  struct stat status {};
  if (::fstat(file.value, &status) != 0 || !S_ISREG(status.st_mode))
    return input_error("File %s is not a regular file.", path.c_str());
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size > limit)
    return input_error("File %s has %llu bytes, more than the limit of %llu.", path.c_str(),
                       static_cast<unsigned long long>(size), static_cast<unsigned long long>(limit));
  std::vector<std::byte> bytes(size);
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::read(file.value, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return input_error("File %s cannot be read: %s.", path.c_str(), std::strerror(errno));
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  bytes.resize(done);
  return bytes;
}

std::string FileWriter::temporary() const { return path_ + ".tmp" + std::to_string(::getpid()); }

Result<FileWriter> FileWriter::create(const std::string& path) {
  FileWriter made(path, -1);
  const std::string name = made.temporary();
  made.file_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (made.file_ < 0)
    return make_error(ErrorKind::Failure, "File %s cannot be written: %s.", name.c_str(),
                      std::strerror(errno));
  return made;
}

FileWriter::~FileWriter() {
  if (file_ < 0) return;
  ::close(file_);
  ::unlink(temporary().c_str());
}

Result<void> FileWriter::append(std::span<const std::byte> bytes) {
  WEFT_CHECK(write_at(size_, bytes));
  size_ += bytes.size();
  return {};
}

Result<void> FileWriter::write_at(std::uint64_t offset, std::span<const std::byte> bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count =
        ::pwrite(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0)
      return make_error(ErrorKind::Failure, "File %s takes only %llu of %llu bytes: %s.", temporary().c_str(),
                        static_cast<unsigned long long>(offset + done),
                        static_cast<unsigned long long>(offset + bytes.size()), std::strerror(errno));
    done += static_cast<std::size_t>(count);
  }
  return {};
}

Result<void> FileWriter::finish() {
  if (::fsync(file_) != 0 && errno != EINVAL)
    return make_error(ErrorKind::Failure, "File %s cannot be synced: %s.", temporary().c_str(),
                      std::strerror(errno));
  if (::rename(temporary().c_str(), path_.c_str()) != 0)
    return make_error(ErrorKind::Failure, "File %s cannot be replaced: %s.", path_.c_str(),
                      std::strerror(errno));
  ::close(std::exchange(file_, -1));
  return {};
}

Result<void> write_file(const std::string& path, std::span<const std::byte> bytes) {
  WEFT_TRY(file, FileWriter::create(path));
  WEFT_CHECK(file.append(bytes));
  return file.finish();
}

Result<void> write_file(const std::string& path, const std::string& text) {
  return write_file(path, std::as_bytes(std::span(text.data(), text.size())));
}

Result<void> make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path, error))
    return make_error(ErrorKind::Failure, "Folder %s cannot be made: %s.", path.c_str(),
                      error ? error.message().c_str() : "a file is in the way");
  return {};
}

}  // namespace weft
