#include "child.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <linux/capability.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

extern char** environ;

namespace weft {
namespace {

std::string name_of(const std::string& variable) { return variable.substr(0, variable.find('=')); }

std::vector<std::string> environment_with(const std::vector<std::string>& changes) {
  std::vector<std::string> all;
  for (char** variable = environ; *variable != nullptr; ++variable) all.emplace_back(*variable);
  for (const std::string& change : changes) {
    const auto same = [&](const std::string& old) { return name_of(old) == name_of(change); };
    all.erase(std::remove_if(all.begin(), all.end(), same), all.end());
    if (change.find('=') != std::string::npos) all.push_back(change);
  }
  return all;
}

std::vector<char*> pointers_to(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

/// Our end and the child's.
struct Ends {
  int ours = -1, theirs = -1;
};

Ends make_pipe() {
  int pipe[2];
  REQUIRE(::pipe2(pipe, O_CLOEXEC) == 0);
  return {pipe[0], pipe[1]};
}

Ends make_terminal() {
  const int ours = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  REQUIRE(ours >= 0);
  REQUIRE(::grantpt(ours) == 0);
  REQUIRE(::unlockpt(ours) == 0);
  const int theirs = ::open(::ptsname(ours), O_RDWR | O_NOCTTY | O_CLOEXEC);
  REQUIRE(theirs >= 0);
  return {ours, theirs};
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

Child::Child(const std::vector<std::string>& arguments, const CallOptions& options) {
  const std::vector<std::string> environment = environment_with(options.environment);
  const std::vector<char*> argv = pointers_to(arguments), envp = pointers_to(environment);
  const Ends out = make_pipe(), err = options.terminal ? make_terminal() : make_pipe();
  id_ = ::fork();
  REQUIRE(id_ >= 0);
  if (id_ == 0) {
    ::setpgid(0, 0);
    if (!options.folder.empty() && ::chdir(options.folder.c_str()) != 0) ::_exit(126);
    const int nothing = ::open("/dev/null", O_RDONLY);
    ::dup2(nothing, 0);
    ::dup2(out.theirs, 1);
    ::dup2(err.theirs, 2);
    ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE);
    ::prctl(PR_CAPBSET_DROP, CAP_DAC_READ_SEARCH);
    ::execve(argv[0], argv.data(), envp.data());
    ::_exit(127);
  }
  ::close(out.theirs);
  ::close(err.theirs);
  files_[0] = out.ours;
  files_[1] = err.ours;
}

Child::~Child() {
  for (const int file : files_)
    if (file >= 0) ::close(file);
  if (id_ < 0) return;
  ::kill(-id_, SIGKILL);
  ::waitpid(id_, nullptr, 0);
}

void Child::signal(int number) const { ::kill(id_, number); }

/// Reads what is there within this time; whether there can be more.
bool Child::read_some(double limit) {
  pollfd polled[2] = {{files_[0], POLLIN, 0}, {files_[1], POLLIN, 0}};  // a negative file is passed over
  ::poll(polled, 2, std::max(0, static_cast<int>(1000 * limit)));
  for (int k = 0; k < 2; ++k) {
    if (polled[k].revents == 0) continue;
    char bytes[65536];
    const ssize_t count = ::read(files_[k], bytes, sizeof bytes);
    if (count > 0) {
      said_[k].append(bytes, static_cast<std::size_t>(count));
    } else {  // a terminal ends with EIO, a pipe with nothing
      ::close(files_[k]);
      files_[k] = -1;
    }
  }
  return files_[0] >= 0 || files_[1] >= 0;
}

Ended Child::wait(double limit) {
  const auto left = [&] {
    return limit - std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  };
  while (left() > 0 && read_some(left())) {
  }
  int status = 0;
  rusage usage = {};
  while (::wait4(id_, &status, WNOHANG, &usage) == 0) {
    if (left() <= 0) {
      ::kill(-id_, SIGKILL);
      ::wait4(id_, &status, 0, &usage);
      id_ = -1;
      return {kTimedOut, said_[0], said_[1], 0, 0};
    }
    ::usleep(500);
  }
  id_ = -1;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), said_[0], said_[1],
          seconds(usage.ru_utime) + seconds(usage.ru_stime),
          static_cast<std::size_t>(usage.ru_maxrss) * 1024};
}

}  // namespace weft
