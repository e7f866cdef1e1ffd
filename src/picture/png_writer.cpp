#include "picture/png_writer.hpp"

#include <algorithm>
#include <utility>

#include "picture/png.hpp"

namespace weft::picture {

PngWriter::PngWriter(std::size_t capacity) : capacity_(std::max<std::size_t>(capacity, 1)) {
  thread_ = std::thread([this] { work(); });
}

PngWriter::~PngWriter() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

Result<void> PngWriter::push(std::string path, Image image) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return jobs_.size() < capacity_ || !first_error_; });
  if (!first_error_) return first_error_;
  jobs_.push_back({std::move(path), std::move(image)});
  changed_.notify_all();
  return {};
}

Result<void> PngWriter::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return (jobs_.empty() && !busy_) || !first_error_; });
  return first_error_;
}

void PngWriter::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return stop_ || !jobs_.empty(); });
    if (jobs_.empty()) return;
    const Job job = std::move(jobs_.front());
    jobs_.pop_front();
    if (!first_error_) continue;
    busy_ = true;
    lock.unlock();
    const Result<void> written = write_png(job.path, job.image);
    lock.lock();
    busy_ = false;
    if (!written) first_error_ = written;
    changed_.notify_all();
  }
}

}  // namespace weft::picture
