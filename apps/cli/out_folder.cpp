#include "out_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

#include "base/file.hpp"
#include "export/parts.hpp"

namespace weft::cli {
namespace {

std::string lock_path(const std::string& folder) { return folder + "/.weft.lock"; }

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

constexpr std::string_view kRows = "frames.csv", kParts = kPartsFile;

/// What a run writes of single frames, with a number between these.
struct Numbered {
  std::string_view begin, end;
  bool after_frame;  // the number is that of the frames before it, else that of its own frame
};
constexpr Numbered kNumbered[] = {{"frame_", ".png", false},
                                  {"mesh_", ".obj", false},
                                  {"mesh_", ".ply", false},
                                  {"checkpoint_", ".weft", true}};

/// The digits between, where this is such a name; else none.
std::string_view number_in(std::string_view name, const Numbered& one) {
  const std::size_t around = one.begin.size() + one.end.size();
  if (name.size() <= around || name.substr(0, one.begin.size()) != one.begin ||
      name.substr(name.size() - one.end.size()) != one.end)
    return {};
  const std::string_view digits = name.substr(one.begin.size(), name.size() - around);
  return is_number(digits) ? digits : std::string_view();
}

/// Whether a run writes files of this name.
bool is_result(std::string_view name) {
  return name == "run.mp4" || name == kRows || name == kParts || name == "final.obj" ||
         name == "summary.json" ||
         std::any_of(std::begin(kNumbered), std::end(kNumbered),
                     [&](const Numbered& one) { return !number_in(name, one).empty(); });
}

/// Whether it is of the frames before this one, which a run that begins there goes on from.
bool is_before(std::string_view name, std::uint32_t frame) {
  if (name == kRows) return true;   // it has rows of them, and others that FrameRows removes
  if (name == kParts) return true;  // of the same cloths, since the scene is the same
  return std::any_of(std::begin(kNumbered), std::end(kNumbered), [&](const Numbered& one) {
    const std::string_view digits = number_in(name, one);
    if (digits.empty() || digits.size() > 9) return false;
    const unsigned long number = std::stoul(std::string(digits));
    return one.after_frame ? number <= frame : number < frame;
  });
}

/// The same for a result that is not whole yet: write_file and VideoWriter.
bool is_temporary_result(std::string_view name) {
  const std::size_t at = name.rfind(".tmp");
  return at != std::string_view::npos && is_number(name.substr(at + 4)) && is_result(name.substr(0, at));
}

Error in_use(const std::string& folder, int lock) {
  char process[32] = "another";
  const ssize_t size = ::pread(lock, process, sizeof process - 1, 0);
  if (size > 0) process[size] = 0;
  return make_error(ErrorKind::Failure, "Folder %s is in use: a run writes into it (process %s).",
                    folder.c_str(), process);
}

/// A file with this process's number in it, locked. The system takes the lock from a process that is gone, so
/// a file that a killed run left behind is in nobody's way. Where there are no locks, every run gets one.
Result<int> lock_folder(const std::string& folder) {
  const std::string path = lock_path(folder);
  for (;;) {
    const int lock = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (lock < 0)
      return make_error(ErrorKind::Failure, "File %s cannot be written: %s.", path.c_str(),
                        std::strerror(errno));
    if (::flock(lock, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      const Error error = in_use(folder, lock);
      ::close(lock);
      return error;
    }
    struct stat locked {
    }, named{};
    const bool still_there = ::fstat(lock, &locked) == 0 && ::stat(path.c_str(), &named) == 0 &&
                             locked.st_dev == named.st_dev && locked.st_ino == named.st_ino;
    const std::string process = std::to_string(::getpid());
    if (still_there && ::ftruncate(lock, 0) == 0 &&
        ::pwrite(lock, process.data(), process.size(), 0) == static_cast<ssize_t>(process.size()))
      return lock;
    const int reason = errno;
    ::close(lock);
    if (still_there)
      return make_error(ErrorKind::Failure, "File %s cannot be written: %s.", path.c_str(),
                        std::strerror(reason));
    // The run that had it has just removed it.
  }
}

Result<void> remove_results(const std::string& folder, std::uint32_t first, const std::string& kept) {
  std::vector<std::string> old;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    const bool keeps =
        first > 0 && (is_before(name, first) || std::filesystem::equivalent(entry->path(), kept, ignored));
    if ((is_result(name) && !keeps) || is_temporary_result(name)) old.push_back(folder + "/" + name);
  }
  if (error)
    return make_error(ErrorKind::Failure, "Folder %s cannot be read: %s.", folder.c_str(),
                      error.message().c_str());
  std::sort(old.begin(), old.end());  // so that the first that cannot be removed is always the same
  for (const std::string& path : old)
    if (::unlink(path.c_str()) != 0 && errno != ENOENT)
      return make_error(ErrorKind::Failure, "File %s of an earlier run cannot be removed: %s.", path.c_str(),
                        std::strerror(errno));
  return {};
}

}  // namespace

Result<OutFolder> OutFolder::take(const std::string& path, std::uint32_t first, const std::string& kept) {
  WEFT_CHECK(make_folder(path));
  WEFT_TRY(lock, lock_folder(path));
  OutFolder folder(path, lock);
  WEFT_CHECK(remove_results(path, first, kept));
  return folder;
}

OutFolder::~OutFolder() {
  if (lock_ < 0) return;
  ::unlink(lock_path(path_).c_str());
  ::close(lock_);
}

}  // namespace weft::cli
