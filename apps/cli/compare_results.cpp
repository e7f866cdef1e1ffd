#include "compare_results.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "bench/compare.hpp"
#include "common.hpp"

namespace weft::cli {
namespace {

using bench::Verdict;

/// A number in a column; "-" where there is none.
std::string cell(double number, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, number);
  return number > 0 ? text : "-";
}

std::string time_cell(const bench::StoredRow& row) { return cell(row.time ? row.time->median : 0, "%.4f"); }

/// Further remarks on a pair; empty if none.
std::string remarks(const bench::Pair& pair) {
  std::string text;
  if (pair.other_bits) text += "; other bits: " + pair.before.state_hash + ", " + pair.after.state_hash;
  if (!pair.before.skipped.empty()) text += "; skipped before: " + pair.before.skipped;
  if (!pair.after.skipped.empty()) text += "; skipped after: " + pair.after.skipped;
  return text;
}

void print_only(const char* where, const std::vector<bench::StoredRow>& rows) {
  for (const bench::StoredRow& row : rows)
    std::printf("only %s: %s: %s\n", where, row.experiment.c_str(), row.name.c_str());
}

void print_table(const bench::Comparison& comparison) {
  std::printf("%-10s %-48s %12s %12s %8s  %s\n", "experiment", "row", "before [ms]", "after [ms]", "ratio",
              "verdict");
  std::set<std::string> adapters;
  for (const bench::Pair& pair : comparison.pairs) {
    std::printf("%-10s %-48s %12s %12s %8s  %s%s\n", pair.before.experiment.c_str(), pair.before.name.c_str(),
                time_cell(pair.before).c_str(), time_cell(pair.after).c_str(),
                cell(pair.ratio, "%.3f").c_str(), name_of(pair.verdict), remarks(pair).c_str());
    if (pair.before.adapter != pair.after.adapter)
      adapters.insert("\"" + pair.before.adapter + "\" and \"" + pair.after.adapter + "\"");
  }
  print_only("before", comparison.only_before);
  print_only("after", comparison.only_after);
  for (const std::string& both : adapters) std::printf("The adapters differ: %s.\n", both.c_str());
  std::printf(
      "%zu rows: %zu slower, %zu faster, %zu within noise, %zu of unknown noise, %zu without a time.\n",
      comparison.pairs.size(), comparison.count(Verdict::Slower), comparison.count(Verdict::Faster),
      comparison.count(Verdict::Same), comparison.count(Verdict::Unknown), comparison.count(Verdict::NotRun));
}

nlohmann::ordered_json names_of(const std::vector<bench::StoredRow>& rows) {
  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  for (const bench::StoredRow& row : rows)
    names.push_back({{"experiment", row.experiment}, {"row", row.name}});
  return names;
}

nlohmann::ordered_json side_of(const bench::StoredRow& row) {
  nlohmann::ordered_json json = {{"adapter", row.adapter}};
  if (row.time) json["ms"] = row.time->median;
  if (!row.state_hash.empty()) json["state_hash"] = row.state_hash;
  if (!row.skipped.empty()) json["skipped"] = row.skipped;
  return json;
}

void print_json(const bench::Comparison& comparison) {
  nlohmann::ordered_json json = {{"pairs", nlohmann::ordered_json::array()}};
  for (const bench::Pair& pair : comparison.pairs) {
    nlohmann::ordered_json one = {{"experiment", pair.before.experiment}, {"row", pair.before.name},
                                  {"before", side_of(pair.before)},       {"after", side_of(pair.after)},
                                  {"verdict", name_of(pair.verdict)},     {"other_bits", pair.other_bits}};
    if (pair.verdict != Verdict::NotRun) one["ratio"] = pair.ratio;
    json["pairs"].push_back(std::move(one));
  }
  json["only_before"] = names_of(comparison.only_before);
  json["only_after"] = names_of(comparison.only_after);
  std::printf("%s\n", json.dump(1).c_str());
}

Result<int> run_compare(const CompareOptions& options) {
  WEFT_TRY(before, bench::read_results(options.before));
  WEFT_TRY(after, bench::read_results(options.after));
  const bench::Comparison comparison = bench::compare(before, after);
  options.json ? print_json(comparison) : print_table(comparison);
  return options.fail && comparison.count(Verdict::Slower) > 0 ? 1 : 0;
}

}  // namespace

int compare_results(const CompareOptions& options) {
  const Result<int> code = run_compare(options);
  return code ? code.value() : report(code.error());
}

}  // namespace weft::cli
