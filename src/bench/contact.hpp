#pragma once

#include <functional>

#include "bench/search_times.hpp"
#include "sim/kernel_times.hpp"

namespace weft::bench {

/// One row of the contact benchmark: what met what and how, what contact cost, and the state it led to.
struct ContactRow {
  std::string pose;    // "flat", "folded", "crumpled": cloth by itself; "draped": on an object
  std::string method;  // "proximity", "proximity_self", "bvh"
  double part = 1;     // of the sheet, that is folded
  std::uint64_t sheets = 1, nodes = 0, cloth_triangles = 0, object_triangles = 0;
  std::uint32_t substeps = 0;      // of a 60 Hz frame, chosen by "auto"
  double dispatches_per_step = 0;  // searches included, recorded in one of search_interval steps
  Timing step;                     // ms a step, searches included, over whole submits
  Timing free_step;                // the same without contact
  Timing search;  // ms a search after the counted submit; 0 where the method has none of its own
  double searches_per_frame = 0;  // of 60 Hz, at the rate of the timed submits
  std::uint64_t contacts = 0;     // that acted in the counted submit
  std::uint32_t counted_steps = 0;
  std::uint32_t pairs = 0, candidates = 0;  // that this search lists
  std::uint32_t crossings = 0;              // the most that any search found
  std::vector<sim::KernelTime> kernels;     // empty: the adapter has no timestamps
  std::string state_hash;                   // after the counted submit, before the timed ones
  std::string skipped;                      // why this row was not run; empty where it was
};

/// What contact costs: cloth that meets itself (flat, folded, crumpled; 10,000 to 640,000 nodes), and cloth
/// on an object of 10,000 to 1,000,000 triangles (`quick`: 800 nodes and 5,000 triangles). All start
/// positions are computed, without a crossing. Each row goes to `done` as it is measured; where that fails,
/// nothing more is run. Errors  Input: scenes/stack.json is missing. DeviceLost, Shader; what is too large
/// for the adapter is a skipped row.
Result<void> run_contact(gpu::Device& device, bool quick, const std::string& scenes_folder,
                         const std::function<Result<void>(const ContactRow&)>& done);

}  // namespace weft::bench
