#include "bench_rows.hpp"

#include <cstdio>

namespace weft::cli {
namespace {

nlohmann::ordered_json json_of(const bench::Timing& timing) {
  return {{"median", timing.median}, {"min", timing.least}};
}

/// The kernels of a part of a frame on one line.
void print_kernels(const bench::ContactRow& row, const char* per) {
  std::string line;
  for (const bench::KernelTime& kernel : row.kernels) {
    char text[64];
    std::snprintf(text, sizeof text, " %s %.4f", kernel.kernel.c_str(), kernel.milliseconds);
    if (kernel.per == per) line += text;
  }
  if (!line.empty()) std::printf("  ms a %s:%s\n", per, line.c_str());
}

}  // namespace

void print_head() {
  std::printf("%-10s %-22s %9s %9s %9s %8s %5s %9s %9s %10s  %s\n", "object", "variant", "nodes", "ms/step",
              "least", "substeps", "disp.", "GB/s", "real time", "contacts", "state hash");
}

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

void print_contact_head(bool has_timestamps) {
  if (!has_timestamps) std::printf("No times by kernel: this adapter has no timestamps.\n");
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
    if (!row.kernels.empty())
      for (const char* per : {"search", "step", "frame"}) print_kernels(row, per);
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
  for (const bench::KernelTime& kernel : row.kernels)
    json["kernels"].push_back({{"kernel", kernel.kernel},
                               {"per", kernel.per},
                               {"dispatches", kernel.dispatches},
                               {"ms", kernel.milliseconds}});
  return json;
}

}  // namespace weft::cli
