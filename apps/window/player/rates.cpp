#include "player/rates.hpp"

namespace weft::window {
namespace {

constexpr double kMean = 1;          // over so long [s]
constexpr double kRefresh = 0.25;    // numbers that change faster cannot be read [s]
constexpr std::size_t kGraph = 120;  // pictures

}  // namespace

void Rates::count(double seconds, double cpu, std::uint64_t frames) {
  if (frames < last_frames_) {
    samples_.clear();
    window_ = 0;
    last_frames_ = frames;
  }
  samples_.push_back({seconds, cpu, static_cast<double>(frames - last_frames_)});
  last_frames_ = frames;
  window_ += seconds;
  while (samples_.size() > 2 && window_ > kMean) {
    window_ -= samples_.front().seconds;
    samples_.erase(samples_.begin());
  }
  graph_.push_back(static_cast<float>(1e3 * seconds));
  if (graph_.size() > kGraph) graph_.erase(graph_.begin());
  since_shown_ += seconds;
  if (since_shown_ < kRefresh || window_ <= 0) return;
  since_shown_ = 0;
  Sample all;
  for (const Sample& sample : samples_) {
    all.cpu += sample.cpu;
    all.frames += sample.frames;
  }
  const auto pictures = static_cast<double>(samples_.size());
  pictures_a_second_ = pictures / window_;
  picture_ms_ = 1e3 * window_ / pictures;
  cpu_ms_ = 1e3 * all.cpu / pictures;
  frames_a_second_ = all.frames / window_;
}

}  // namespace weft::window
