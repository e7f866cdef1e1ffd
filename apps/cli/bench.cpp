#include "bench.hpp"

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "bench/hanging.hpp"
#include "bench/pull.hpp"
#include "bench_rows.hpp"

namespace weft::cli {
namespace {

/// Prints rows as they come, and keeps the file of results whole after each, so that a run that is cut off
/// leaves what it has measured.
class Results {
 public:
  Results(const gpu::Device& device, const BenchOptions& options)
      : file_(options.json),
        json_{{"bench", options.name},
              {"adapter", device.adapter().name},
              {"driver", device.adapter().driver},
              {"unchecked", options.unchecked},
              {"rows", nlohmann::ordered_json::array()}} {}

  template <class AnyRow>
  Result<void> add(const AnyRow& row) {
    print(row);
    json_["rows"].push_back(json_of(row));
    return file_.empty() ? Result<void>() : write_file(file_, json_.dump(1) + "\n");
  }

 private:
  std::string file_;
  nlohmann::ordered_json json_;
};

Result<void> run_bench(const BenchOptions& options) {
  gpu::DeviceOptions device_options;
  device_options.adapter = options.adapter;
  device_options.unchecked = options.unchecked;
  device_options.timestamps = options.name == "contact";
  WEFT_TRY(device, gpu::Device::create(device_options));
  std::printf("%s, %s%s\n", device->adapter().name.c_str(), device->adapter().driver.c_str(),
              options.unchecked ? ", kernels unchecked" : "");
  Results results(*device, options);
  const auto add = [&](const auto& row) { return results.add(row); };
  const std::filesystem::path root = std::filesystem::path(models_folder()).parent_path();
  const bench::Folders folders{(root / "scenes").string(), models_folder()};
  if (options.name == "contact") {
    print_contact_head(device->has_timestamps());
    return bench::run_contact(*device, options.quick, folders.scenes, add);
  }
  print_head();
  if (options.name == "hanging") return bench::run_hanging(*device, options.quick, add);
  return bench::run_pull(*device, options.quick, folders, add);
}

}  // namespace

int bench(const BenchOptions& options) {
  const Result<void> result = run_bench(options);
  return result ? 0 : report(result.error());
}

}  // namespace weft::cli
