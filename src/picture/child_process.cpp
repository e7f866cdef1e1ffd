#include "picture/child_process.hpp"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

extern char** environ;

namespace weft::picture {
namespace {

/// Keeps SIGPIPE from this thread while it lives, so that a write to a dead program is an error and not our
/// end.
class NoPipeSignal {
 public:
  NoPipeSignal() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~NoPipeSignal() {
    const timespec now = {0, 0};
    if (!was_pending_)  // what a write of ours raised is taken away; what was there before stays
      while (sigtimedwait(&pipe_, nullptr, &now) == -1 && errno == EINTR) {
      }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;

 private:
  sigset_t pipe_, before_;
  bool was_pending_ = false;
};

/// A nameless file in /tmp.
int open_nameless() {
  char name[] = "/tmp/weft-said-XXXXXX";
  const int file = ::mkostemp(name, O_CLOEXEC);
  if (file >= 0) ::unlink(name);
  return file;
}

}  // namespace

std::optional<std::string> find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  const std::string folders = path != nullptr ? path : "";
  for (std::size_t begin = 0; begin <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', begin), folders.size());
    if (end > begin) {
      const std::string file = folders.substr(begin, end - begin) + "/" + name;
      if (::access(file.c_str(), X_OK) == 0) return file;
    }
    begin = end + 1;
  }
  return std::nullopt;
}

Result<ChildProcess> ChildProcess::start(const std::vector<std::string>& arguments) {
  ChildProcess child;
  child.name_ = arguments[0].substr(arguments[0].rfind('/') + 1);
  int pipe[2];
  if (::pipe2(pipe, O_CLOEXEC) != 0)
    return make_error(ErrorKind::Failure, "No pipe to %s can be made: %s.", child.name_.c_str(),
                      std::strerror(errno));
  child.input_ = pipe[1];
  child.said_ = open_nameless();

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, pipe[0], 0);
  posix_spawn_file_actions_addopen(&files, 1, "/dev/null", O_WRONLY, 0);
  if (child.said_ >= 0)
    posix_spawn_file_actions_adddup2(&files, child.said_, 2);
  else
    posix_spawn_file_actions_addopen(&files, 2, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  posix_spawnattr_setpgroup(&attributes, 0);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);

  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const int error = ::posix_spawn(&child.id_, argv[0], &files, &attributes, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  ::close(pipe[0]);
  if (error != 0) {
    child.id_ = -1;
    return make_error(ErrorKind::Failure, "Program %s cannot be started: %s.", argv[0], std::strerror(error));
  }
  return child;
}

ChildProcess::~ChildProcess() {
  close_input();
  if (id_ > 0) {
    ::kill(id_, SIGKILL);
    while (::waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  if (said_ >= 0) ::close(said_);
}

Result<void> ChildProcess::write(std::span<const std::byte> bytes) {
  const NoPipeSignal guard;
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(input_, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      const int reason = errno;
      WEFT_CHECK(finish());
      return make_error(ErrorKind::Failure, "Program %s takes no more input: %s.", name_.c_str(),
                        std::strerror(reason));
    }
    done += static_cast<std::size_t>(count);
  }
  return {};
}

Result<void> ChildProcess::finish() {
  close_input();
  if (id_ <= 0) return make_error(ErrorKind::Failure, "Program %s has ended before.", name_.c_str());
  int status = 0;
  while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  id_ = -1;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  const std::string words = last_words();
  if (WIFSIGNALED(status))
    return make_error(ErrorKind::Failure, "Program %s was ended by signal %d%s%s.", name_.c_str(),
                      WTERMSIG(status), words.empty() ? "" : ": ", words.c_str());
  return make_error(ErrorKind::Failure, "Program %s failed with exit code %d%s%s.", name_.c_str(),
                    WEXITSTATUS(status), words.empty() ? "" : ": ", words.c_str());
}

void ChildProcess::close_input() {
  if (input_ >= 0) ::close(input_);
  input_ = -1;
}

/// The last line that the program wrote to standard error, without its full stop.
std::string ChildProcess::last_words() {
  if (said_ < 0) return {};
  char text[4096];
  const off_t size = ::lseek(said_, 0, SEEK_END);
  const off_t from = std::max<off_t>(0, size - static_cast<off_t>(sizeof text));
  const ssize_t count = ::pread(said_, text, sizeof text, from);
  std::string words(text, count > 0 ? static_cast<std::size_t>(count) : 0);
  words.erase(words.find_last_not_of("\n .") + 1);
  return words.substr(words.rfind('\n') + 1);
}

}  // namespace weft::picture
