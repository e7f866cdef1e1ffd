#include "validate.hpp"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "common.hpp"
#include "method/method.hpp"
#include "validate/law.hpp"

namespace weft::cli {
namespace {

using validate::Bound;
using validate::Measure;
using validate::Row;

const char* word_of(Bound bound) {
  if (bound == Bound::AtMost) return "at_most";
  return bound == Bound::AtLeast ? "at_least" : "near";
}

/// What a value may be, as "0.7002 ± 2 %".
std::string allowed(const Measure& measure) {
  const char* sign = measure.bound == Bound::AtMost ? "+" : measure.bound == Bound::AtLeast ? "-" : "±";
  char text[64];
  if (measure.expected == 0)
    std::snprintf(text, sizeof text, "0 %s %g", sign, measure.tolerance);
  else
    std::snprintf(text, sizeof text, "%.5g %s %g %%", measure.expected, sign, 100 * measure.tolerance);
  return text;
}

void print(const Row& row) {
  std::printf("%-12s %-11s %-6s %12.5g %-5s of %-18s %s\n", std::string(row.law->name).c_str(),
              scene::name_of(row.solver), row.measure.holds() ? "holds" : "FAILS", row.measure.value,
              row.measure.unit.c_str(), allowed(row.measure).c_str(), row.measure.what.c_str());
  std::fflush(stdout);
}

nlohmann::ordered_json json_of(const Row& row) {
  const Measure& measure = row.measure;
  return {{"law", row.law->name},
          {"solver", scene::name_of(row.solver)},
          {"what", measure.what},
          {"unit", measure.unit},
          {"value", measure.value},  // null where it is not a number
          {"expected", measure.expected},
          {"tolerance", measure.tolerance},
          {"bound", word_of(measure.bound)},
          {"holds", measure.holds()}};
}

struct Outcome {
  std::size_t rows = 0, failed = 0;
};

Result<Outcome> run_validate(const ValidateOptions& options) {
  WEFT_CHECK(check_names("--only", options.only, law_names()));
  std::vector<std::string_view> kinds;
  for (const Method& method : methods()) kinds.push_back(scene::name_of(method.kind));
  if (!options.solver.empty()) WEFT_CHECK(check_names("--solver", {options.solver}, kinds));
  gpu::DeviceOptions device_options;
  device_options.adapter = options.adapter;
  WEFT_TRY(device, gpu::Device::create(device_options));
  const AdapterInfo& adapter = device->adapter();
  nlohmann::ordered_json json{{"adapter", adapter.name}, {"driver", adapter.driver}};
  json["laws"] = nlohmann::ordered_json::array();
  for (const validate::Law& law : validate::laws())
    json["laws"].push_back({{"name", law.name}, {"statement", law.statement}});
  json["rows"] = nlohmann::ordered_json::array();
  if (!options.json) std::printf("%s, %s\n", adapter.name.c_str(), adapter.driver.c_str());
  Outcome outcome;
  for (const Method& method : methods()) {
    if (!options.solver.empty() && options.solver != scene::name_of(method.kind)) continue;
    WEFT_CHECK(
        validate::measure_laws({*device, method.kind}, options.only, [&](const Row& row) -> Result<void> {
          ++outcome.rows;
          outcome.failed += row.measure.holds() ? 0 : 1;
          if (options.json)
            json["rows"].push_back(json_of(row));
          else
            print(row);
          if (interrupted()) return make_error(ErrorKind::Interrupted, "The validation is interrupted.");
          return {};
        }));
  }
  if (options.json)
    std::printf("%s\n", json.dump(1).c_str());
  else
    std::printf("%zu of %zu numbers hold.\n", outcome.rows - outcome.failed, outcome.rows);
  return outcome;
}

}  // namespace

std::vector<std::string_view> law_names() {
  std::vector<std::string_view> names;
  for (const validate::Law& law : validate::laws()) names.push_back(law.name);
  return names;
}

int validate(const ValidateOptions& options) {
  const auto outcome = run_validate(options);
  if (!outcome) return report(outcome.error());
  return outcome->failed == 0 ? 0 : exit_code(ErrorKind::Failure);
}

}  // namespace weft::cli
