#include "bench.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "assets.hpp"
#include "base/file.hpp"
#include "base/json.hpp"
#include "bench/hanging.hpp"
#include "bench/scene_run.hpp"
#include "bench_rows.hpp"
#include "common.hpp"
#include "memory.hpp"

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

Result<void> check_selection(const BenchOptions& options) {
  const bench::Selection& selection = options.selection;
  WEFT_CHECK(check_names("--only", selection.only,
                         options.name == "pull"        ? bench::pull_variants()
                         : options.name == "multigrid" ? bench::multigrid_variants()
                         : options.name == "methods"   ? bench::method_names()
                                                       : bench::hanging_variants()));
  if (options.name == "methods") return check_names("--scenes", selection.objects, bench::method_scenes());
  return check_names("--objects", selection.objects, bench::pull_objects());
}

Result<bench::Budget> budget_of(const BenchOptions& options) {
  bench::Budget budget;
  budget.seconds = options.seconds;
  if (options.memory) {
    budget.bytes = static_cast<std::uint64_t>(*options.memory * (1U << 30U));
    return budget;
  }
  WEFT_TRY(available, available_memory());
  budget.bytes = available / 4;
  return budget;
}

gpu::DeviceOptions device_options(const BenchOptions& options) {
  gpu::DeviceOptions of_device;
  of_device.adapter = options.adapter;
  of_device.unchecked = options.unchecked;
  of_device.timestamps = true;
  return of_device;
}

Result<std::unique_ptr<gpu::Device>> open_device(const BenchOptions& options) {
  WEFT_TRY(device, gpu::Device::create(device_options(options)));
  std::printf("%s, %s%s\n", device->adapter().name.c_str(), device->adapter().driver.c_str(),
              options.unchecked ? ", kernels unchecked" : "");
  return device;
}

Result<void> measure_scene(const BenchOptions& options) {
  WEFT_TRY(scene, load(options.scene));
  if (options.frames) scene.time.frames = *options.frames;
  WEFT_TRY(assets, load_checked_assets(scene));
  WEFT_TRY(device, open_device(options));
  Results results(*device, options);
  print_sheet_head();
  return bench::run_scene(*device, std::filesystem::path(options.scene.path).stem().string(), scene, assets,
                          [&](const auto& row) { return results.add(row); });
}

Result<void> run_bench(const BenchOptions& options) {
  WEFT_CHECK(check_selection(options));
  if (options.name == "scene") return measure_scene(options);
  WEFT_TRY(device, open_device(options));
  Results results(*device, options);
  const auto add = [&](const auto& row) { return results.add(row); };
  if (options.name == "copy") return bench::run_copy(*device, options.selection.quick, add);
  if (options.name == "largest") {
    WEFT_TRY(budget, budget_of(options));
    device.reset();  // it makes its own
    return bench::run_largest(device_options(options), options.selection, budget, add);
  }
  const std::filesystem::path root = std::filesystem::path(models_folder()).parent_path();
  const bench::Folders folders{(root / "scenes").string(), models_folder()};
  if (!device->has_timestamps()) std::printf("No times by kernel: this adapter has no timestamps.\n");
  if (options.name == "contact") {
    print_contact_head();
    return bench::run_contact(*device, options.selection.quick, folders.scenes, add);
  }
  if (options.name == "multigrid") {
    print_sheet_head();
    return bench::run_multigrid(*device, options.selection, folders, add);
  }
  if (options.name == "methods") {
    print_sheet_head();
    return bench::run_methods(*device, options.selection, folders, add);
  }
  print_head();
  if (options.name == "hanging") return bench::run_hanging(*device, options.selection, add);
  return bench::run_pull(*device, options.selection, folders, add);
}

}  // namespace

int bench(const BenchOptions& options) {
  const Result<void> result = run_bench(options);
  return result ? 0 : report(result.error());
}

}  // namespace weft::cli
