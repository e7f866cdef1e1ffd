#include "gpu/timer.hpp"

#include <cassert>

#include "gpu/readback.hpp"

namespace weft::gpu {

Result<Timer> Timer::create(Device& device, std::uint32_t max_spans) {
  if (!device.has_timestamps())
    return make_error(ErrorKind::Limit, "Adapter %s has no timestamp queries.",
                      device.adapter().name.c_str());
  Timer timer;
  timer.device_ = &device;
  timer.max_spans_ = max_spans;
  WEFT_TRY(queries, backend::create_timestamp_queries(device.context(), 2 * max_spans, "timer"));
  timer.queries_ = Object(ObjectKind::QuerySet, queries);
  WEFT_TRY(ticks, Buffer<std::uint64_t>::create(device, 2UL * max_spans, "timer ticks",
                                                kQueryResolve | kCopySource));
  timer.ticks_ = std::move(ticks);
  return timer;
}

PassTimestamps Timer::span(const std::string& label) {
  assert(labels_.size() < max_spans_);
  const auto first = static_cast<std::uint32_t>(2 * labels_.size());
  labels_.push_back(label);
  return {queries_.id(), first, first + 1};
}

void Timer::finish(CommandList& list) {
  list.resolve_queries(queries_.id(), static_cast<std::uint32_t>(2 * labels_.size()), ticks_.id());
}

Result<std::vector<Timer::Span>> Timer::read() {
  WEFT_TRY(ticks, download(*device_, ticks_));
  const double period = backend::timestamp_period(device_->context());  // ns
  std::vector<Span> spans;
  for (std::size_t i = 0; i < labels_.size(); ++i)
    spans.push_back({labels_[i], static_cast<double>(ticks[2 * i + 1] - ticks[2 * i]) * period * 1e-6});
  labels_.clear();
  return spans;
}

}  // namespace weft::gpu
