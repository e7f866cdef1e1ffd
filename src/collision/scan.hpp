#pragma once

#include <cstdint>

#include "gpu/kernel.hpp"
#include "state/contact_pairs.hpp"

namespace weft::collision {

/// Mirror of shaders/contact/scan_params.wgsl.
struct ScanParams {
  std::uint32_t count = 0, stride = 1, source = 0, sums = 0, first_block = 0, capacity = 0;
  std::uint32_t padding[2] = {};
};
static_assert(sizeof(ScanParams) == 32);

/// How much comes before each of many numbers: within blocks of kScanBlock, and before each block. Two
/// dispatches. Reads   words, statistics: whether a detection is due. Writes  words; statistics, where the
/// numbers count pairs. Errors  Shader, OutOfMemory.
class Scan {
 public:
  Scan() = default;
  static Result<Scan> create(gpu::Device& device, const ScanParams& params,
                             const gpu::Buffer<std::uint32_t>& statistics,
                             const gpu::Buffer<std::uint32_t>& words);
  void record(gpu::ComputePass& pass) const;

 private:
  gpu::Kernel blocks_, sums_;
  gpu::RawBuffer params_;
  gpu::BindGroup blocks_group_, sums_group_;
  std::uint32_t block_count_ = 0;
};

}  // namespace weft::collision
