#include "progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace weft::cli {

Progress::Progress(std::string what, std::uint32_t total)
    : what_(std::move(what)), total_(total), visible_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (visible_) std::fputs("\r\033[K", stderr);
}

void Progress::show(std::uint32_t done, double milliseconds_per_item) {
  if (!visible_ || total_ == 0) return;
  constexpr std::uint32_t kWidth = 30;
  const auto filled = static_cast<std::uint32_t>(static_cast<std::uint64_t>(done) * kWidth / total_);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
  const double left = done == 0 ? 0 : passed.count() / done * (total_ - done);
  std::string bar(filled, '#');
  bar.resize(kWidth, '.');
  std::fprintf(stderr, "\r%s [%s] %u/%u  %.1f ms a frame  %.0f s left\033[K", what_.c_str(), bar.c_str(),
               done, total_, milliseconds_per_item, left);
  std::fflush(stderr);
}

}  // namespace weft::cli
