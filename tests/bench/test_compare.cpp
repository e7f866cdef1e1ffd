#include <doctest/doctest.h>

#include "base/file.hpp"
#include "bench/compare.hpp"
#include "temporary_folder.hpp"

using namespace weft;
using bench::Verdict;

namespace {

std::string times(double low, double median, double high, int samples = 9) {
  const auto text = [](double number) { return std::to_string(number); };
  return R"("ms_per_step": {"median": )" + text(median) + R"(, "spread": {"p05": )" + text(low) +
         R"(, "p95": )" + text(high) + R"(}, "samples": )" + std::to_string(samples) + "}";
}

std::string single(const std::string& rows, const std::string& name = "pull") {
  return R"({"bench": ")" + name + R"(", "adapter": "card", "rows": [)" + rows + "]}";
}

class Files {
 public:
  Result<std::vector<bench::StoredRow>> read(const std::string& text) {
    REQUIRE(write_file(folder_.path("results.json"), text));
    return bench::read_results(folder_.path("results.json"));
  }
  std::vector<bench::StoredRow> rows(const std::string& text) {
    auto read_rows = read(text);
    REQUIRE_MESSAGE(read_rows, (read_rows ? "" : read_rows.error().message));
    return *read_rows;
  }
  Verdict verdict(const std::string& before, const std::string& after) {
    const bench::Comparison made =
        bench::compare(rows(single("{" + before + "}")), rows(single("{" + after + "}")));
    REQUIRE(made.pairs.size() == 1);
    return made.pairs[0].verdict;
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("a row is slower or faster only where the two runs' times lie apart") {
  Files files;
  CHECK(files.verdict(times(1.0, 1.1, 1.2), times(1.3, 1.4, 1.5)) == Verdict::Slower);
  CHECK(files.verdict(times(1.3, 1.4, 1.5), times(1.0, 1.1, 1.2)) == Verdict::Faster);
  CHECK(files.verdict(times(1.0, 1.1, 1.35), times(1.3, 1.4, 1.5)) == Verdict::Same);
  CHECK(files.verdict(times(1.3, 1.4, 1.5), times(1.0, 1.1, 1.35)) == Verdict::Same);
  CHECK(files.verdict(times(1, 1, 1, 1), times(2, 2, 2)) == Verdict::Unknown);  // one submit has no noise
  CHECK(files.verdict(R"("ms_per_step": {"median": 1})", times(2, 2, 2)) == Verdict::Unknown);
  CHECK(files.verdict(R"("skipped": "too slow")", times(2, 2, 2)) == Verdict::NotRun);
  CHECK(files.verdict(R"("ms": {"median": 1})", R"("ms": {"median": 3})") == Verdict::Unknown);  // of `copy`
}

TEST_CASE("rows are paired by what is not measured; the rest of both files is listed") {
  Files files;
  const std::string sphere = R"("object": "sphere", "variant": "bvh", "nodes": 4096, )";
  const auto before =
      files.rows(single("{" + sphere + times(1, 1, 1) + R"(, "contacts": 3, "state_hash": "a"}, )" +
                        R"({"object": "sphere", "variant": "paper", "nodes": 4096})"));
  const auto after = files.rows(single(
      R"({"object": "dragon", "variant": "bvh", "nodes": 4096}, {"side": 64, )" + sphere + times(2, 2, 2) +
      R"(, "contacts": 4, "crossings": 0, "crossings_left": 0, "reference_substeps": 8,
                 "repeated_frames": 1, "simulated_nodes": 9, "command": "x", "binary": "sha256:1",
                 "state_hash": "b"})"));
  CHECK(before[0].name == "sphere, bvh, nodes 4096");
  const bench::Comparison made = bench::compare(before, after);
  REQUIRE(made.pairs.size() == 1);
  CHECK(made.pairs[0].ratio == doctest::Approx(2));
  CHECK(made.pairs[0].other_bits);
  REQUIRE(made.only_before.size() == 1);
  CHECK(made.only_before[0].name == "sphere, paper, nodes 4096");
  REQUIRE(made.only_after.size() == 1);
  CHECK(made.only_after[0].name == "dragon, bvh, nodes 4096");
  CHECK(!bench::compare(before, before).pairs[0].other_bits);
}

TEST_CASE(
    "the sizes that `largest` finds do not name its rows, and the object's triangles do name those of "
    "`contact`") {
  Files files;
  CHECK(files
            .rows(single(
                R"({"limits": "default", "variant": "grid", "side": 9, "nodes": 81, "gpu_bytes": 5})"))[0]
            .name == "default, grid");
  const auto rows = files.rows(single(R"({"pose": "draped", "part": 1, "nodes": 9, "object_triangles": 10},
                                         {"pose": "draped", "part": 1, "nodes": 9, "object_triangles": 20})"));
  CHECK(rows[1].name == "draped, part 1, nodes 9, object_triangles 20");
}

TEST_CASE("a machine's file is compared with that of one experiment") {
  Files files;
  const auto machine = files.rows(R"({"format": "weft-bench/1", "machine": "m", "experiments": {
    "hanging": {"adapter": "card", "command": "c", "rows": [{"nodes": 9}]},
    "pull": {"adapter": "card", "rows": [{"nodes": 9}]}}})");
  REQUIRE(machine.size() == 2);
  const bench::Comparison made = bench::compare(machine, files.rows(single(R"({"nodes": 9})")));
  REQUIRE(made.pairs.size() == 1);
  CHECK(made.pairs[0].before.experiment == "pull");
  CHECK(made.pairs[0].before.adapter == "card");
  CHECK(made.only_before.size() == 1);
}

TEST_CASE("what is no file of results is refused with the reason") {
  Files files;
  struct Bad {
    const char *text, *words;
  };
  for (const Bad& bad :
       {Bad{"{", "line 1"}, Bad{"{}", "neither \"bench\" nor \"format\""},
        Bad{"[]", "neither \"bench\" nor \"format\""},
        Bad{R"({"format": "weft-scene/1"})", "\"weft-scene/1\""},
        Bad{R"({"format": "weft-bench/1"})", "no object \"experiments\""},
        Bad{R"({"format": "weft-bench/1", "experiments": {"pull": {}}})", "no list of rows for \"pull\""},
        Bad{R"({"format": "weft-bench/1", "experiments": {"pull": 3}})", "no list of rows for \"pull\""},
        Bad{R"({"bench": "pull", "rows": [3]})", "has 3 among the rows of \"pull\""},
        Bad{R"({"bench": "pull", "rows": [{"nodes": 9}, {"nodes": 9}]})", "two rows"}}) {
    CAPTURE(bad.text);
    const auto read = files.read(bad.text);
    REQUIRE_FALSE(read);
    CHECK(read.error().kind == ErrorKind::Input);
    CHECK_MESSAGE(read.error().message.find(bad.words) != std::string::npos, read.error().message);
  }
  CHECK(bench::read_results("/nonexistent/results.json").error().kind == ErrorKind::Input);
}
