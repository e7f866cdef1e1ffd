#include "collision/scan.hpp"

namespace weft::collision {

Result<Scan> Scan::create(gpu::Device& device, const ScanParams& params,
                          const gpu::Buffer<std::uint32_t>& statistics,
                          const gpu::Buffer<std::uint32_t>& words) {
  Scan made;
  made.block_count_ = scan_blocks(params.count);
  WEFT_TRY(blocks, gpu::Kernel::create(device, "contact/scan_blocks.wgsl"));
  made.blocks_ = std::move(blocks);
  WEFT_TRY(sums, gpu::Kernel::create(device, "contact/scan_sums.wgsl"));
  made.sums_ = std::move(sums);
  WEFT_TRY(buffer, gpu::Buffer<ScanParams>::create_from(device, std::span(&params, 1), "scan params",
                                                        gpu::kUniform | gpu::kCopyTarget));
  WEFT_TRY(blocks_group, made.blocks_.bind({buffer, statistics, words}));
  made.blocks_group_ = std::move(blocks_group);
  WEFT_TRY(sums_group, made.sums_.bind({buffer, statistics, words}));
  made.sums_group_ = std::move(sums_group);
  made.params_ = std::move(buffer);
  return made;
}

void Scan::record(gpu::ComputePass& pass) const {
  blocks_.dispatch_groups(pass, blocks_group_, block_count_);
  sums_.dispatch_groups(pass, sums_group_, 1);
}

}  // namespace weft::collision
