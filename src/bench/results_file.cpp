#include "bench/results_file.hpp"

#include <algorithm>
#include <set>
#include <string_view>

#include "base/file.hpp"
#include "base/json.hpp"

namespace weft::bench {
namespace {

using Kind = Json::Kind;

constexpr double kLeastSamples = 5;  // for the 5 and 95 of 100 to be more than all there is

/// What a row has found out, or how it came about. All else that is a text or a number names it.
constexpr std::string_view kFound[] = {"adapter",
                                       "binary",
                                       "bytes_per_step",
                                       "candidates",
                                       "command",
                                       "contacts",
                                       "counted_steps",
                                       "crossings",
                                       "dispatches_per_step",
                                       "fps",
                                       "gb_per_s",
                                       "gpu_bytes",
                                       "limited_by",
                                       "max_stretch",
                                       "note",
                                       "pairs",
                                       "real_time_factor",
                                       "scene",
                                       "searches_per_frame",
                                       "skipped",
                                       "springs",
                                       "state_hash",
                                       "substeps",
                                       "us"};

/// Whether a member says which row this is.
bool names_row(const Json& row, const std::string& member) {
  if (std::find(std::begin(kFound), std::end(kFound), member) != std::end(kFound)) return false;
  if (member == "side") return row.find("nodes") == nullptr;               // it says the same, in newer files
  if (member == "object_triangles") return row.find("object") == nullptr;  // a skipped row has the name only
  if (member == "nodes") return row.find("limits") == nullptr;             // else the largest that fit
  return true;
}

std::string name_of(const Json& row) {
  std::string name;
  for (std::size_t k = 0; k < row.names.size(); ++k) {
    const Json& value = row.values[k];
    if (!names_row(row, row.names[k]) || (value.kind != Kind::Text && value.kind != Kind::Number)) continue;
    if (!name.empty()) name += ", ";
    name += value.kind == Kind::Text ? value.text : row.names[k] + " " + number_text(value.number);
  }
  return name;
}

std::string text_of(const Json& object, std::string_view member) {
  const Json* value = object.find(member);
  return value != nullptr && value->kind == Kind::Text ? value->text : "";
}

std::optional<double> number_of(const Json& object, std::string_view member) {
  const Json* value = object.find(member);
  if (value == nullptr || value->kind != Kind::Number) return std::nullopt;
  return value->number;
}

std::optional<StoredTime> time_of(const Json& row) {
  const Json* times = row.find("ms_per_step");
  if (times == nullptr) times = row.find("ms");
  const std::optional<double> median = times == nullptr ? std::nullopt : number_of(*times, "median");
  if (!median || !(*median > 0)) return std::nullopt;
  StoredTime time{*median, std::nullopt};
  const Json* spread = times->find("spread");
  if (spread == nullptr || number_of(*times, "samples").value_or(0) < kLeastSamples) return time;
  const std::optional<double> low = number_of(*spread, "p05"), high = number_of(*spread, "p95");
  if (low && high) time.spread = StoredTime::Spread{*low, *high};
  return time;
}

Result<void> add_rows(std::vector<StoredRow>& rows, const std::string& path, const std::string& experiment,
                      const Json& results) {
  const Json* list = results.find("rows");
  if (list == nullptr || list->kind != Kind::List)
    return input_error("%s has no list of rows for %s.", path.c_str(), in_quotes(experiment).c_str());
  std::set<std::string> names;
  for (const Json& row : list->values) {
    if (row.kind != Kind::Object)
      return input_error("%s has %s among the rows of %s.", path.c_str(), describe(row).c_str(),
                         in_quotes(experiment).c_str());
    rows.push_back({experiment, name_of(row), time_of(row), text_of(row, "state_hash"),
                    text_of(row, "skipped"), text_of(results, "adapter")});
    if (!names.insert(rows.back().name).second)
      return input_error("%s has two rows of %s for %s; nothing tells them apart.", path.c_str(),
                         in_quotes(experiment).c_str(), in_quotes(rows.back().name).c_str());
  }
  return {};
}

}  // namespace

Result<std::vector<StoredRow>> read_results(const std::string& path) {
  WEFT_TRY(bytes, read_file(path, kMaxJsonBytes));
  WEFT_TRY(root, parse_json({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path));
  std::vector<StoredRow> rows;
  const std::string format = text_of(root, "format");
  if (format.empty()) {
    const std::string experiment = text_of(root, "bench");
    if (experiment.empty())
      return input_error("%s has no results of weft bench: neither \"bench\" nor \"format\" is in it.",
                         path.c_str());
    WEFT_CHECK(add_rows(rows, path, experiment, root));
    return rows;
  }
  if (format != "weft-bench/1")
    return input_error("%s has the format %s; this weft compares \"weft-bench/1\".", path.c_str(),
                       in_quotes(format).c_str());
  const Json* experiments = root.find("experiments");
  if (experiments == nullptr || experiments->kind != Kind::Object)
    return input_error("%s has no object \"experiments\".", path.c_str());
  for (std::size_t k = 0; k < experiments->names.size(); ++k)
    WEFT_CHECK(add_rows(rows, path, experiments->names[k], experiments->values[k]));
  return rows;
}

}  // namespace weft::bench
