#pragma once

#include <functional>

#include "bench/measure.hpp"

namespace weft::bench {

/// What the adapter can do at best: to be set beside what a step takes.
struct CopyRow {
  std::string what;  // "copy": one buffer into another by a kernel; "dispatch": one that does next to nothing
  std::uint64_t bytes = 0;  // of the buffer that is copied
  Timing time;              // ms a copy, or a dispatch
};

/// Copies between two buffers of up to 256 MiB (`quick`: 16) to and fro by a kernel, as a step reads and
/// writes them, and a chain of dispatches each of which waits for the one before; many to a submit, queue
/// drained after each. Errors  OutOfMemory, DeviceLost.
Result<void> run_copy(gpu::Device& device, bool quick,
                      const std::function<Result<void>(const CopyRow&)>& done);

}  // namespace weft::bench
