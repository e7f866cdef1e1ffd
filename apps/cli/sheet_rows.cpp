#include <cstdio>

#include "bench_rows.hpp"

namespace weft::cli {
namespace {

nlohmann::ordered_json json_of(const bench::SheetError& error) {
  return {{"t", error.time},
          {"position", error.position},
          {"normal_degrees", error.normal_degrees},
          {"edge_stretch", error.edge_stretch},
          {"edge_stretch_reference", error.edge_stretch_reference},
          {"kinetic_energy", error.kinetic_energy},
          {"kinetic_energy_reference", error.kinetic_energy_reference}};
}

/// The time of a part of what `timing` timed.
bench::Timing part_of(bench::Timing timing, double parts) {
  for (double* time : {&timing.median, &timing.least, &timing.low, &timing.high}) *time /= parts;
  return timing;
}

}  // namespace

void print_sheet_head() {
  std::printf("%-10s %-13s %8s %9s %9s %8s %6s %9s  %s\n", "object", "variant", "nodes", "ms/frame", "least",
              "substeps", "disp.", "real time", "state hash");
}

void print(const bench::SheetRow& row) {
  std::printf("%-10s %-13s %8llu ", row.object.c_str(), row.variant.c_str(),
              static_cast<unsigned long long>(row.nodes));
  if (!row.skipped.empty()) {
    std::printf(" skipped: %s\n", row.skipped.c_str());
  } else {
    std::printf("%9.3f %9.3f %8u %6.1f %9.3g  %s\n", row.run.frame.median, row.run.frame.least,
                row.run.substeps, row.run.dispatches_per_step, row.run.real_time_factor,
                row.state_hash.c_str());
    for (const bench::SheetError& e : row.errors)
      std::printf(
          "  %4.2f s: position %.2f %%, normals %.2f deg, sides %+.3f %% (%+.3f %%), %.4g J (%.4g J)\n",
          e.time, 100 * e.position, e.normal_degrees, 100 * e.edge_stretch, 100 * e.edge_stretch_reference,
          e.kinetic_energy, e.kinetic_energy_reference);
    if (row.contact)
      std::printf("  crossings %u (%u left), stretch at most %.4f\n", row.contact->crossings,
                  row.contact->crossings_left, row.contact->max_stretch);
    print_kernels(row.run.kernels);
  }
  std::fflush(stdout);
}

nlohmann::ordered_json json_of(const bench::SheetRow& row) {
  nlohmann::ordered_json json = {{"object", row.object},
                                 {"variant", row.variant},
                                 {"nodes", row.nodes},
                                 {"simulated_nodes", row.simulated_nodes}};
  if (row.side > 0) json["side"] = row.side;
  if (!row.skipped.empty()) {
    json["skipped"] = row.skipped;
    return json;
  }
  json["substeps"] = row.run.substeps;
  json["dispatches_per_step"] = row.run.dispatches_per_step;
  if (row.run.totals.iterations > 0) {
    json["iterations"] = row.run.totals.iterations;
    json["residual"] = row.run.totals.residual;
    json["unsolved"] = row.run.totals.unsolved;
  }
  json["ms_per_frame"] = json_of(row.run.frame);
  json["ms_per_step"] = json_of(part_of(row.run.frame, row.run.substeps));
  json["real_time_factor"] = row.run.real_time_factor;
  json["gpu_bytes"] = row.run.gpu_bytes;
  if (!row.errors.empty()) json["reference_substeps"] = row.reference_substeps;
  for (const bench::SheetError& error : row.errors) json["error"].push_back(json_of(error));
  if (row.contact) {
    json["contacts"] = row.contact->contacts;
    json["crossings"] = row.contact->crossings;
    json["crossings_left"] = row.contact->crossings_left;
    json["max_stretch"] = row.contact->max_stretch;
    json["repeated_frames"] = row.contact->repeated_frames;
  }
  json["state_hash"] = row.state_hash;
  add_kernels(json, row.run.kernels);
  return json;
}

}  // namespace weft::cli
