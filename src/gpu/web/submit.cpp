// Submits, and bytes that come back.
#include <algorithm>

#include "gpu/web/context.hpp"

namespace weft::gpu::backend {

Result<void> submit(Context& context, std::span<const CommandList* const> lists) {
  WEFT_CHECK(context.take_error());
  context.lists.clear();
  for (const CommandList* list : lists)
    context.lists.push_back({list->commands().data(), static_cast<std::uint32_t>(list->commands().size()),
                             list->targets().data()});
  web::weft_gpu_submit(context.lists.data(), static_cast<std::uint32_t>(context.lists.size()));
  return {};
}

void poll(Context& context) {  // the JavaScript side has written to the states already
  std::erase_if(context.mapping, [](const auto& state) { return *state != MapState::Pending; });
}

void wait(Context& context) {
  web::weft_gpu_wait();
  poll(context);
}

void map_read(Context& context, Id buffer, std::uint64_t bytes, const std::shared_ptr<MapState>& state) {
  static_assert(sizeof(MapState) == sizeof(std::uint32_t));
  context.mapping.push_back(state);
  web::weft_gpu_map(handle(buffer), static_cast<double>(bytes),
                    reinterpret_cast<std::uint32_t*>(state.get()));
}

void take_mapped(Id buffer, std::span<std::byte> target) {
  web::weft_gpu_take_mapped(handle(buffer), target.data(), static_cast<std::uint32_t>(target.size()));
}

}  // namespace weft::gpu::backend
