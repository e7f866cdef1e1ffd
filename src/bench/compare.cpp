#include "bench/compare.hpp"

#include <algorithm>

namespace weft::bench {
namespace {

const StoredRow* find(const std::vector<StoredRow>& rows, const StoredRow& wanted) {
  const auto at = std::find_if(rows.begin(), rows.end(), [&](const StoredRow& row) {
    return row.experiment == wanted.experiment && row.name == wanted.name;
  });
  return at == rows.end() ? nullptr : &*at;
}

Verdict judge(const StoredTime& before, const StoredTime& after) {
  if (!before.spread || !after.spread) return Verdict::Unknown;
  if (after.spread->low > before.spread->high) return Verdict::Slower;
  return after.spread->high < before.spread->low ? Verdict::Faster : Verdict::Same;
}

Pair pair_of(const StoredRow& before, const StoredRow& after) {
  Pair pair{before, after};
  pair.other_bits =
      !before.state_hash.empty() && !after.state_hash.empty() && before.state_hash != after.state_hash;
  if (!before.time || !after.time) return pair;
  pair.ratio = after.time->median / before.time->median;
  pair.verdict = judge(*before.time, *after.time);
  return pair;
}

}  // namespace

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::Unknown:
      return "noise unknown";
    case Verdict::Same:
      return "within noise";
    case Verdict::Slower:
      return "slower";
    case Verdict::Faster:
      return "faster";
    case Verdict::NotRun:
      break;
  }
  return "no time";
}

std::size_t Comparison::count(Verdict verdict) const {
  return static_cast<std::size_t>(
      std::count_if(pairs.begin(), pairs.end(), [&](const Pair& pair) { return pair.verdict == verdict; }));
}

Comparison compare(const std::vector<StoredRow>& before, const std::vector<StoredRow>& after) {
  Comparison made;
  for (const StoredRow& row : before) {
    if (const StoredRow* other = find(after, row))
      made.pairs.push_back(pair_of(row, *other));
    else
      made.only_before.push_back(row);
  }
  for (const StoredRow& row : after)
    if (find(before, row) == nullptr) made.only_after.push_back(row);
  return made;
}

}  // namespace weft::bench
