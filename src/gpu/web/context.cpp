// The browser's adapter and device, and how its errors and its loss arrive.
#include "gpu/web/context.hpp"

#include <sstream>

namespace weft::gpu::backend {

std::string take_text() {
  std::string text(web::weft_gpu_text_size(), '\0');
  web::weft_gpu_text(text.data());
  return text;
}

Result<void> Context::take_error() {
  if (error == 0) return {};
  const auto kind = static_cast<ErrorKind>(web::weft_gpu_take_error());
  return Error{kind, take_text()};
}

void ContextDeleter::operator()(Context* context) const {
  web::weft_gpu_close();
  delete context;
}

Result<Opened> open(const DeviceOptions& options) {
  Opened opened;
  opened.context = ContextPointer(new Context);
  const std::uint32_t failed =
      web::weft_gpu_open(options.adapter.data(), static_cast<std::uint32_t>(options.adapter.size()),
                         options.timestamps ? 1 : 0, &opened.context->error);
  if (failed != 0) return Error{static_cast<ErrorKind>(failed - 1), take_text()};
  std::istringstream lines(take_text());
  for (std::string* field : {&opened.adapter.name, &opened.adapter.vendor, &opened.adapter.driver,
                             &opened.adapter.backend, &opened.adapter.type})
    std::getline(lines, *field);
  double limits[8] = {};
  opened.timestamps = web::weft_gpu_limits(limits) != 0;
  opened.limits = {static_cast<std::uint64_t>(limits[0]), static_cast<std::uint64_t>(limits[1]),
                   static_cast<std::uint32_t>(limits[2]), static_cast<std::uint32_t>(limits[3]),
                   static_cast<std::uint32_t>(limits[4]), static_cast<std::uint32_t>(limits[5]),
                   static_cast<std::uint32_t>(limits[6]), static_cast<std::uint32_t>(limits[7])};
  return opened;
}

Result<std::vector<AdapterInfo>> list_adapters() {
  return make_error(ErrorKind::Failure, "A browser does not list its adapters.");
}

Result<void> status(Context& context) { return context.take_error(); }

void lose(Context&) { web::weft_gpu_lose(); }

}  // namespace weft::gpu::backend
