#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "gpu/buffer.hpp"
#include "gpu/command_list.hpp"
#include "gpu/device.hpp"

namespace weft::gpu {

/// Times passes on the GPU. Timestamps stand only at the bounds of passes, so an instrumented run splits into
/// more passes than a plain one: use it to see shares, not to quote totals.
class Timer {
 public:
  struct Span {
    std::string label;
    double milliseconds = 0;
  };

  Timer() = default;
  /// Errors  Limit: the device was made without timestamps, or has none.
  static Result<Timer> create(Device& device, std::uint32_t max_spans);

  /// The queries for the next pass; give them to ComputePass. `label` names the span.
  PassTimestamps span(const std::string& label);
  /// Records the resolve; call after the last timed pass.
  void finish(CommandList& list);
  /// The times of all spans, waited for; then the spans are cleared.
  Result<std::vector<Span>> read();

 private:
  Device* device_ = nullptr;
  Object queries_;
  Buffer<std::uint64_t> ticks_;
  std::vector<std::string> labels_;
  std::uint32_t max_spans_ = 0;
};

}  // namespace weft::gpu
