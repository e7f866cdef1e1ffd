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

Result<void> write_and_sync(const std::string& path, std::span<const std::byte> bytes) {
  const Descriptor file{::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)};
  if (file.value < 0)
    return make_error(ErrorKind::Failure, "File %s cannot be written: %s.", path.c_str(),
                      std::strerror(errno));
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(file.value, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0)
      return make_error(ErrorKind::Failure, "File %s takes only %zu of %zu bytes: %s.", path.c_str(), done,
                        bytes.size(), std::strerror(errno));
    done += static_cast<std::size_t>(count);
  }
  if (::fsync(file.value) != 0 && errno != EINVAL)
    return make_error(ErrorKind::Failure, "File %s cannot be synced: %s.", path.c_str(),
                      std::strerror(errno));
  return {};
}

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

Result<void> write_file(const std::string& path, std::span<const std::byte> bytes) {
  const std::string temporary = path + ".tmp" + std::to_string(::getpid());
  if (auto written = write_and_sync(temporary, bytes); !written) {
    ::unlink(temporary.c_str());
    return written.error();
  }
  if (::rename(temporary.c_str(), path.c_str()) != 0) {
    const int reason = errno;
    ::unlink(temporary.c_str());
    return make_error(ErrorKind::Failure, "File %s cannot be replaced: %s.", path.c_str(),
                      std::strerror(reason));
  }
  return {};
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
