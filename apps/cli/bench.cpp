#include "bench.hpp"

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "bench/hanging.hpp"
#include "bench/pull.hpp"

namespace weft::cli {
namespace {

void print(const bench::Row& row) {
  if (!row.skipped.empty()) {
    std::printf("%-10s %-22s %9llu  skipped: %s\n", row.object.c_str(), row.variant.c_str(),
                static_cast<unsigned long long>(row.nodes), row.skipped.c_str());
    return;
  }
  std::printf("%-10s %-22s %9llu %9.4f %9.4f %8u %5.1f %9.1f %9.3g %10llu  %s\n", row.object.c_str(),
              row.variant.c_str(), static_cast<unsigned long long>(row.nodes), row.ms_per_step,
              row.ms_per_step_min, row.substeps, row.dispatches_per_step,
              row.bytes_per_step / row.ms_per_step * 1e-6, row.real_time_factor,
              static_cast<unsigned long long>(row.contacts), row.state_hash.c_str());
  std::fflush(stdout);
}

nlohmann::ordered_json json_of(const bench::Row& row) {
  nlohmann::ordered_json json = {{"object", row.object}, {"variant", row.variant}, {"nodes", row.nodes}};
  if (!row.skipped.empty()) {
    json["skipped"] = row.skipped;
    return json;
  }
  json["springs"] = row.springs;
  json["object_triangles"] = row.object_triangles;
  json["substeps"] = row.substeps;
  json["dispatches_per_step"] = row.dispatches_per_step;
  json["ms_per_step"] = {{"median", row.ms_per_step}, {"min", row.ms_per_step_min}};
  json["real_time_factor"] = row.real_time_factor;
  json["bytes_per_step"] = row.bytes_per_step;
  json["contacts"] = row.contacts;
  json["state_hash"] = row.state_hash;
  return json;
}

Result<void> run_bench(const BenchOptions& options) {
  gpu::DeviceOptions device_options;
  device_options.adapter = options.adapter;
  device_options.unchecked = options.unchecked;
  WEFT_TRY(device, gpu::Device::create(device_options));
  std::printf("%s, %s%s\n", device->adapter().name.c_str(), device->adapter().driver.c_str(),
              options.unchecked ? ", kernels unchecked" : "");
  std::printf("%-10s %-22s %9s %9s %9s %8s %5s %9s %9s %10s  %s\n", "object", "variant", "nodes", "ms/step",
              "least", "substeps", "disp.", "GB/s", "real time", "contacts", "state hash");
  const std::filesystem::path root = std::filesystem::path(models_folder()).parent_path();
  const bench::Folders folders{(root / "scenes").string(), models_folder()};
  auto rows = options.name == "hanging" ? bench::run_hanging(*device, options.quick, print)
                                        : bench::run_pull(*device, options.quick, folders, print);
  if (!rows) return rows.error();
  if (options.json.empty()) return {};
  nlohmann::ordered_json json = {{"bench", options.name},
                                 {"adapter", device->adapter().name},
                                 {"driver", device->adapter().driver},
                                 {"unchecked", options.unchecked}};
  for (const bench::Row& row : *rows) json["rows"].push_back(json_of(row));
  return write_file(options.json, json.dump(1) + "\n");
}

}  // namespace

int bench(const BenchOptions& options) {
  const Result<void> result = run_bench(options);
  return result ? 0 : report(result.error());
}

}  // namespace weft::cli
