#include "bench/copy.hpp"

#include <algorithm>

#include "gpu/kernel.hpp"
#include "gpu/readback.hpp"

namespace weft::bench {
namespace {

Result<Timing> time_list(gpu::Device& device, const gpu::CommandList& list, std::uint32_t parts, bool quick) {
  const auto submit = [&]() -> Result<void> {
    WEFT_CHECK(device.submit(list));
    return device.wait();
  };
  WEFT_CHECK(submit());  // the first use of a buffer clears it
  return time_repeats(quick ? 100 : 1000, 5, parts, submit);
}

Result<CopyRow> measure_copy(gpu::Device& device, bool quick) {
  const std::uint64_t mebibytes = quick ? 16 : 256;
  const std::uint32_t copies = quick ? 4 : 64;
  const std::uint64_t most =
      std::min(device.limits().max_buffer_size, device.limits().max_storage_binding_size) / 16 * 16;
  const std::uint64_t bytes = std::min(mebibytes << 20U, most);
  const std::size_t count = bytes / sizeof(Vec4f);
  WEFT_TRY(a, gpu::Buffer<Vec4f>::create(device, count, "copy a"));
  WEFT_TRY(b, gpu::Buffer<Vec4f>::create(device, count, "copy b"));
  WEFT_TRY(kernel, gpu::Kernel::create(device, "bench/copy.wgsl"));
  WEFT_TRY(there, kernel.bind({a, b}));
  WEFT_TRY(back, kernel.bind({b, a}));
  gpu::CommandList list;
  {
    gpu::ComputePass pass(list, "copies to and fro");
    for (std::uint32_t k = 0; k < copies; ++k) kernel.dispatch(pass, k % 2 == 0 ? there : back, count);
  }
  WEFT_TRY(time, time_list(device, list, copies, quick));
  return CopyRow{"copy", bytes, time};
}

Result<CopyRow> measure_dispatch(gpu::Device& device, bool quick) {
  const std::uint32_t dispatches = quick ? 100 : 1000;
  WEFT_TRY(word, gpu::Buffer<std::uint32_t>::create(device, 1, "counted word"));
  WEFT_TRY(kernel, gpu::Kernel::create(device, "bench/count_up.wgsl", {}, 1));
  WEFT_TRY(group, kernel.bind({word}));
  gpu::CommandList list;
  {
    gpu::ComputePass pass(list, "dispatches in order");
    for (std::uint32_t k = 0; k < dispatches; ++k) kernel.dispatch_groups(pass, group, {1});
  }
  WEFT_TRY(time, time_list(device, list, dispatches, quick));
  WEFT_TRY(counted, gpu::download(device, word));
  if (counted[0] != dispatches * (time.samples + 1))
    return make_error(ErrorKind::Failure, "%u dispatches in order have counted to %u only.",
                      dispatches * (time.samples + 1), counted[0]);
  return CopyRow{"dispatch", 0, time};
}

}  // namespace

Result<void> run_copy(gpu::Device& device, bool quick,
                      const std::function<Result<void>(const CopyRow&)>& done) {
  WEFT_TRY(copy, measure_copy(device, quick));
  WEFT_CHECK(done(copy));
  WEFT_TRY(dispatch, measure_dispatch(device, quick));
  return done(dispatch);
}

}  // namespace weft::bench
