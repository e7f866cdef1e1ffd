#include "bench_rows.hpp"

#include <cstdio>

namespace weft::cli {
namespace {

/// The kernels of a part of a frame on one line.
void print_kernels(const std::vector<sim::KernelTime>& kernels, const char* per) {
  std::string line;
  for (const sim::KernelTime& kernel : kernels) {
    char text[64];
    std::snprintf(text, sizeof text, " %s %.4f", kernel.kernel.c_str(), kernel.milliseconds);
    if (kernel.per == per) line += text;
  }
  if (!line.empty()) std::printf("  ms a %s:%s\n", per, line.c_str());
}

}  // namespace

void print_kernels(const std::vector<sim::KernelTime>& kernels) {
  for (const char* per : {"search", "step", "frame"}) print_kernels(kernels, per);
}

void add_kernels(nlohmann::ordered_json& json, const std::vector<sim::KernelTime>& kernels) {
  for (const sim::KernelTime& kernel : kernels)
    json["kernels"].push_back({{"kernel", kernel.kernel},
                               {"per", kernel.per},
                               {"dispatches", kernel.dispatches},
                               {"ms", kernel.milliseconds}});
}

nlohmann::ordered_json json_of(const bench::Timing& timing) {
  return {{"median", timing.median},
          {"min", timing.least},
          {"spread", {{"p05", timing.low}, {"p95", timing.high}}},
          {"samples", timing.samples}};
}

void print_head() {
  std::printf("%-10s %-22s %9s %9s %9s %8s %5s %9s %9s %9s %10s  %s\n", "object", "variant", "nodes",
              "ms/step", "least", "substeps", "disp.", "GB/s", "real time", "frames/s", "contacts",
              "state hash");
}

void print(const bench::Row& row) {
  std::printf("%-10s %-22s %9llu ", row.object.c_str(), row.variant.c_str(),
              static_cast<unsigned long long>(row.nodes));
  if (!row.skipped.empty()) {
    std::printf(" skipped: %s\n", row.skipped.c_str());
  } else {
    std::printf("%9.4f %9.4f %8u %5.1f %9.1f %9.3g %9.4g %10llu  %s\n", row.step.median, row.step.least,
                row.substeps, row.dispatches_per_step, row.bytes_per_step / row.step.median * 1e-6,
                row.real_time_factor, 1000 / row.paper_frame.median,
                static_cast<unsigned long long>(row.contacts), row.state_hash.c_str());
    print_kernels(row.kernels);
  }
  std::fflush(stdout);
}

nlohmann::ordered_json json_of(const bench::Row& row) {
  nlohmann::ordered_json json = {
      {"object", row.object}, {"variant", row.variant}, {"side", row.side}, {"nodes", row.nodes}};
  if (!row.skipped.empty()) {
    json["skipped"] = row.skipped;
    return json;
  }
  json["springs"] = row.springs;
  json["object_triangles"] = row.object_triangles;
  json["substeps"] = row.substeps;
  json["dispatches_per_step"] = row.dispatches_per_step;
  json["ms_per_step"] = json_of(row.step);
  json["real_time_factor"] = row.real_time_factor;
  json["bytes_per_step"] = row.bytes_per_step;
  json["gpu_bytes"] = row.gpu_bytes;
  json["paper_frame"] = {{"ms", json_of(row.paper_frame)}, {"fps", 1000 / row.paper_frame.median}};
  if (row.start) json["start"] = *row.start;
  json["contacts"] = row.contacts;
  if (row.outcome) {
    json["crossings"] = row.outcome->crossings;
    json["max_stretch"] = row.outcome->max_stretch;
  }
  json["state_hash"] = row.state_hash;
  add_kernels(json, row.kernels);
  return json;
}

void print_contact_head() {
  std::printf("%-9s %5s %-14s %8s %9s %9s %9s %9s %9s %8s %5s %9s %9s %9s %5s  %s\n", "pose", "part",
              "method", "nodes", "object", "ms/search", "ms/step", "contact", "a frame", "substeps", "disp.",
              "contacts", "pairs", "candid.", "cross", "state hash");
}

void print(const bench::ContactRow& row) {
  using Count = unsigned long long;
  std::printf("%-9s %5.3g %-14s %8llu %9llu ", row.pose.c_str(), row.part, row.method.c_str(),
              static_cast<Count>(row.nodes), static_cast<Count>(row.object_triangles));
  if (!row.skipped.empty()) {
    std::printf("skipped: %s\n", row.skipped.c_str());
  } else {
    std::printf("%9.4f %9.4f %9.4f %9.1f %8u %5.1f %9llu %9u %9u %5u  %s\n", row.search.median,
                row.step.median, row.step.median - row.free_step.median, row.searches_per_frame, row.substeps,
                row.dispatches_per_step, static_cast<Count>(row.contacts), row.pairs, row.candidates,
                row.crossings, row.state_hash.c_str());
    print_kernels(row.kernels);
  }
  std::fflush(stdout);
}

nlohmann::ordered_json json_of(const bench::ContactRow& row) {
  nlohmann::ordered_json json = {{"pose", row.pose},
                                 {"part", row.part},
                                 {"method", row.method},
                                 {"sheets", row.sheets},
                                 {"nodes", row.nodes},
                                 {"cloth_triangles", row.cloth_triangles},
                                 {"object_triangles", row.object_triangles},
                                 {"substeps", row.substeps},
                                 {"ms_per_step_without_contact", json_of(row.free_step)}};
  if (!row.skipped.empty()) {
    json["skipped"] = row.skipped;
    return json;
  }
  json["dispatches_per_step"] = row.dispatches_per_step;
  json["ms_per_step"] = json_of(row.step);
  json["ms_per_search"] = json_of(row.search);
  json["searches_per_frame"] = row.searches_per_frame;
  json["counted_steps"] = row.counted_steps;
  json["contacts"] = row.contacts;
  json["pairs"] = row.pairs;
  json["candidates"] = row.candidates;
  json["crossings"] = row.crossings;
  json["state_hash"] = row.state_hash;
  add_kernels(json, row.kernels);
  return json;
}

namespace {

/// Read and written bytes both count.
double gigabytes_per_second(const bench::CopyRow& row) {
  return 2e-6 * static_cast<double>(row.bytes) / row.time.median;
}

}  // namespace

void print(const bench::CopyRow& row) {
  if (row.bytes > 0)
    std::printf("copy of %.0f MiB: %.1f GB/s, read and written bytes both counted\n",
                static_cast<double>(row.bytes) / (1U << 20U), gigabytes_per_second(row));
  else
    std::printf("dispatch in order: %.2f us\n", 1000 * row.time.median);
  std::fflush(stdout);
}

nlohmann::ordered_json json_of(const bench::CopyRow& row) {
  nlohmann::ordered_json json = {{"what", row.what}};
  if (row.bytes > 0) {
    json["bytes"] = row.bytes;
    json["gb_per_s"] = gigabytes_per_second(row);
  } else {
    json["us"] = 1000 * row.time.median;
  }
  json["ms"] = json_of(row.time);
  return json;
}

void print(const bench::LargestRow& row) {
  std::printf("%-7s limits, %-22s: %s%u x %u = %llu nodes, %.2f GiB on the GPU", row.limits.c_str(),
              row.variant.c_str(), row.skipped.empty() ? "" : "about ", row.side, row.side,
              static_cast<unsigned long long>(row.nodes), static_cast<double>(row.gpu_bytes) / (1U << 30U));
  if (row.skipped.empty())
    std::printf(", %.4f ms a step; the next: %s\n", row.step.median, row.limited_by.c_str());
  else
    std::printf(" for a %s; not run: %s\n", row.limited_by.c_str(), row.skipped.c_str());
  std::fflush(stdout);
}

nlohmann::ordered_json json_of(const bench::LargestRow& row) {
  nlohmann::ordered_json json = {
      {"limits", row.limits}, {"variant", row.variant},       {"side", row.side},
      {"nodes", row.nodes},   {"limited_by", row.limited_by}, {"gpu_bytes", row.gpu_bytes}};
  if (row.skipped.empty())
    json["ms_per_step"] = json_of(row.step);
  else
    json["skipped"] = row.skipped;
  return json;
}

}  // namespace weft::cli
