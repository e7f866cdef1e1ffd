#include "sim/report_ring.hpp"

#include <algorithm>

namespace weft::sim {

Result<ReportRing> ReportRing::create(gpu::Device& device, const State& state) {
  ReportRing ring;
  for (Slot& slot : ring.slots_) {
    WEFT_TRY(readback, gpu::Readback::create(device, sizeof(Statistics), "frame report"));
    slot.readback = std::move(readback);
    slot.commands.copy(state.statistics.source(), slot.readback.target());
  }
  return ring;
}

const ReportRing::Slot* ReportRing::free_slot() const {
  const auto slot =
      std::find_if(slots_.begin(), slots_.end(), [](const Slot& one) { return !one.readback.pending(); });
  return slot == slots_.end() ? nullptr : &*slot;
}

bool ReportRing::has_room() const { return free_slot() != nullptr; }

const gpu::CommandList& ReportRing::commands() const { return free_slot()->commands; }

void ReportRing::expect(std::uint32_t frame, std::uint32_t attempt, std::uint32_t parity) {
  Slot& slot = slots_[static_cast<std::size_t>(free_slot() - slots_.data())];
  slot.frame = frame;
  slot.attempt = attempt;
  slot.parity = parity;
  slot.readback.start();
}

Result<std::optional<Report>> ReportRing::take(gpu::Device& device, bool wait) {
  Slot* first = nullptr;  // in the order of their frames, so that the first bad one is the one that is named
  for (Slot& slot : slots_)
    if (slot.readback.pending() && (first == nullptr || slot.frame < first->frame)) first = &slot;
  if (first == nullptr) return std::optional<Report>();
  const auto arrived = [&] { return first->readback.ready() || first->readback.failed(); };
  while (wait && !arrived()) device.poll();
  if (!arrived()) return std::optional<Report>();
  Report report{first->frame, first->attempt, first->parity, {}};
  const bool failed = first->readback.failed();
  first->readback.take(std::as_writable_bytes(std::span(&report.statistics, 1)));
  if (!failed) return std::optional(report);
  WEFT_CHECK(device.status());
  return make_error(ErrorKind::DeviceLost, "The report of frame %u did not arrive.", report.frame);
}

void ReportRing::drop() {
  for (Slot& slot : slots_)
    if (slot.readback.pending()) slot.readback.take();
}

}  // namespace weft::sim
