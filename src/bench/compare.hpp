// Two stored results beside each other.
#pragma once

#include "bench/results_file.hpp"

namespace weft::bench {

enum class Verdict {
  Unknown,  // a run does not say how noisy it was
  Same,     // within the noise of the two
  Slower,
  Faster,
  NotRun,  // skipped in one of them, or without a time
};
const char* name_of(Verdict verdict);

struct Pair {
  StoredRow before, after;
  double ratio = 0;  // of the times, after / before; 0 where one is missing
  Verdict verdict = Verdict::NotRun;
  bool other_bits = false;  // both have a state hash, and they differ
};

struct Comparison {
  std::vector<Pair> pairs;
  std::vector<StoredRow> only_before, only_after;

  std::size_t count(Verdict verdict) const;
};

/// Pairs rows by experiment and name. Two times differ where 5 of 100 and 95 of 100 of one run's lie all on
/// one side of the other's.
Comparison compare(const std::vector<StoredRow>& before, const std::vector<StoredRow>& after);

}  // namespace weft::bench
