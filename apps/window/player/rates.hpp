#pragma once

#include <cstdint>
#include <vector>

namespace weft::window {

/// How fast pictures come and the scene goes: means over a second, shown anew a few times a second.
class Rates {
 public:
  /// A picture was shown, so much later than the one before [s]. `cpu`: what it took this thread [s]; `frames`: that
  /// have been simulated so far; fewer than before: the scene has begun again.
  void count(double seconds, double cpu, std::uint64_t frames);

  double pictures_a_second() const { return pictures_a_second_; }
  double picture_ms() const { return picture_ms_; }
  double cpu_ms() const { return cpu_ms_; }
  double frames_a_second() const { return frames_a_second_; }
  /// Of the last pictures [ms].
  const std::vector<float>& graph() const { return graph_; }

 private:
  struct Sample {
    double seconds = 0, cpu = 0, frames = 0;
  };

  std::vector<Sample> samples_;
  double window_ = 0, since_shown_ = 0;  // [s]
  double pictures_a_second_ = 0, picture_ms_ = 0, cpu_ms_ = 0, frames_a_second_ = 0;
  std::uint64_t last_frames_ = 0;
  std::vector<float> graph_;
};

}  // namespace weft::window
