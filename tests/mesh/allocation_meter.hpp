// Counts what operator new hands out in this test program.
#pragma once

#include <cstddef>

namespace weft {

/// The most bytes that were allocated at once since the meter was made, beyond what was allocated then.
class AllocationMeter {
 public:
  AllocationMeter();
  std::size_t peak() const;

 private:
  std::size_t before_;
};

}  // namespace weft
