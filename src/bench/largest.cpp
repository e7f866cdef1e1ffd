#include "bench/largest.hpp"

#include <chrono>
#include <cstdio>

#include "bench/largest_side.hpp"

namespace weft::bench {
namespace {

constexpr std::uint32_t kFirstSide = 32;
constexpr std::uint32_t kBeyond = 65536;  // its nodes have no u32 numbers
constexpr double kMargin = 0.5;           // of the largest stable step

bool is_software(const gpu::Device& device) { return device.adapter().type == "CPU"; }

/// Of a submit: enough that a submit's own time is small beside them, on a GPU.
std::uint32_t steps_of(const gpu::Device& device) { return is_software(device) ? 2 : 64; }

/// On the host for each node while a world is built. Seen from 256² to 600² nodes, less the bytes of the GPU:
/// 820 on a grid, 760 with springs, 1050 on a mesh, most of them for the springs of its highest frequency.
constexpr double kHostBytes = 1050;

/// Tries sizes, and remembers what the last one that fits has shown.
class Trials {
 public:
  Trials(gpu::Device& device, Formulation formulation, const Budget& budget)
      : device_(device), formulation_(formulation), budget_(budget) {}

  Result<Trial> attempt(std::uint32_t side) {
    const double nodes = static_cast<double>(side) * side;
    if (const auto counted = sim::check_node_count(static_cast<std::uint64_t>(nodes), device_); !counted)
      return Trial{Trial::Outcome::Refused, 0, counted.error().message};
    if (const std::string why = too_much(nodes); !why.empty()) return Trial{Trial::Outcome::Untried, 0, why};
    const auto start = std::chrono::steady_clock::now();
    device_.take_largest_buffer();
    auto world = build(side, 1e-9);
    if (!world && (world.error().kind == ErrorKind::Limit || world.error().kind == ErrorKind::OutOfMemory))
      return Trial{Trial::Outcome::Refused, 0, world.error().message};
    if (!world) return world.error();
    seconds_per_node_ =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / nodes;
    stable_step_ = (*world)->plan().limit().largest_step;
    gpu_bytes_ = device_.allocated_bytes();
    gpu_bytes_per_node_ = static_cast<double>(gpu_bytes_) / nodes;
    return Trial{Trial::Outcome::Fits, device_.take_largest_buffer(), ""};
  }

  /// Some steps of the last size that fits.
  Result<Timing> run(std::uint32_t side) {
    WEFT_TRY(world, build(side, kMargin * stable_step_));
    WEFT_CHECK(world->advance_frame());
    WEFT_CHECK(world->finish());
    return time_steps(*world, 300, 3);
  }

  std::uint64_t gpu_bytes() const { return gpu_bytes_; }
  double gpu_bytes_per_node() const { return gpu_bytes_per_node_; }

 private:
  Result<std::unique_ptr<sim::World>> build(std::uint32_t side, double step) {
    WEFT_TRY(sheet, make_hanging_sheet(side, formulation_));
    const std::uint32_t steps = steps_of(device_);
    sheet.scene.time.substeps = steps;
    sheet.scene.time.frame = steps * step;
    return sim::World::create(device_, std::move(sheet.scene), sheet.assets);
  }

  /// What the budget lacks for so many nodes; empty if nothing.
  std::string too_much(double nodes) const {
    const double bytes = nodes * (kHostBytes + (is_software(device_) ? gpu_bytes_per_node_ : 0));
    const double seconds = nodes * seconds_per_node_;
    char why[160] = "";
    if (bytes > static_cast<double>(budget_.bytes))
      std::snprintf(why, sizeof why,
                    "its %.0f nodes need about %.2f GiB of memory, more than the %.2f allowed", nodes,
                    bytes / (1U << 30U), static_cast<double>(budget_.bytes) / (1U << 30U));
    else if (seconds > budget_.seconds)
      std::snprintf(why, sizeof why,
                    "its %.0f nodes would take about %.3g s to build, more than the %g allowed", nodes,
                    seconds, budget_.seconds);
    return why;
  }

  gpu::Device& device_;
  Formulation formulation_;
  Budget budget_;
  double seconds_per_node_ = 0, gpu_bytes_per_node_ = 0, stable_step_ = 0;
  std::uint64_t gpu_bytes_ = 0;
};

}  // namespace

Result<LargestRow> measure_largest(gpu::Device& device, Formulation formulation, const std::string& limits,
                                   const Budget& budget) {
  Trials trials(device, formulation, budget);
  const std::uint64_t limit = device.limits().max_storage_binding_size;
  WEFT_TRY(found, find_largest_side(kFirstSide, kBeyond, limit,
                                    [&](std::uint32_t side) { return trials.attempt(side); }));
  LargestRow row;
  row.limits = limits;
  row.variant = name_of(formulation);
  row.side = found.side;
  row.nodes = static_cast<std::uint64_t>(found.side) * found.side;
  row.skipped = found.untried;
  if (!found.untried.empty()) {
    row.limited_by = "maxStorageBufferBindingSize of " + std::to_string(limit);
    row.gpu_bytes = static_cast<std::uint64_t>(trials.gpu_bytes_per_node() * static_cast<double>(row.nodes));
    return row;
  }
  row.limited_by = found.refusal;
  row.gpu_bytes = trials.gpu_bytes();
  WEFT_TRY(step, trials.run(found.side));
  row.step = step;
  return row;
}

Result<void> run_largest(gpu::DeviceOptions options, const Selection& selection, const Budget& budget,
                         const std::function<Result<void>(const LargestRow&)>& done) {
  for (const bool defaults : {true, false}) {
    options.default_limits = defaults;
    WEFT_TRY(device, gpu::Device::create(options));
    for (std::size_t k = 0; k < std::size(kFormulations); ++k) {
      if (!selection.has_variant(hanging_variants()[k])) continue;
      WEFT_TRY(row, measure_largest(*device, kFormulations[k], defaults ? "default" : "adapter", budget));
      WEFT_CHECK(done(row));
    }
  }
  return {};
}

}  // namespace weft::bench
