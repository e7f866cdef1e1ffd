#include <doctest/doctest.h>

#include "weft.hpp"

using namespace weft;

namespace {

constexpr double kLimit = 200;  // s; a run takes some 8 s on two cores of its own

nlohmann::json bench_contact(const TemporaryFolder& folder, const std::string& name) {
  const std::string file = folder.path(name);
  Child child(weft_command({"bench", "contact", "--quick", "--json", file}), on_lavapipe({}));
  const Ended ended = child.wait(kLimit);
  REQUIRE_MESSAGE(ended.code == 0, ended.err);
  CHECK(ended.err == "");
  nlohmann::json results = json_of(read_text(file));
  for (const auto& row : results.at("rows"))  // what is printed is what is stored
    CHECK(ended.out.find(row.at("state_hash").get<std::string>()) != std::string::npos);
  CHECK(names_in(folder.path("")).size() == (name == "a.json" ? 1 : 2));  // no temporary file is left
  return results;
}

/// Of each part of a frame the kernels that were timed.
std::string kernels_of(const nlohmann::json& row, const std::string& per) {
  std::string names;
  for (const auto& kernel : row.at("kernels")) {
    CHECK(kernel.at("ms") >= 0);
    CHECK(kernel.at("dispatches") >= 1);
    if (kernel.at("per") == per) names += kernel.at("kernel").get<std::string>() + " ";
  }
  return names;
}

}  // namespace

TEST_CASE("bench contact gives the same rows and the same bits in two runs, and starts without crossings") {
  const TemporaryFolder folder;
  const nlohmann::json first = bench_contact(folder, "a.json"), second = bench_contact(folder, "b.json");
  CHECK(first.at("bench") == "contact");
  CHECK(first.at("adapter").get<std::string>().find("llvmpipe") != std::string::npos);
  std::string rows;
  REQUIRE(first.at("rows").size() == second.at("rows").size());
  for (std::size_t r = 0; r < first.at("rows").size(); ++r) {
    const nlohmann::json &row = first["rows"][r], &again = second["rows"][r];
    const std::string pose = row.at("pose"), method = row.at("method");
    rows += pose + " " + method + ", ";
    CAPTURE(rows);
    CHECK(row.at("state_hash").get<std::string>().size() == 16);
    for (const char* same : {"pose", "method", "nodes", "object_triangles", "substeps", "dispatches_per_step",
                             "counted_steps", "contacts", "pairs", "candidates", "state_hash", "crossings"})
      CHECK(row.at(same) == again.at(same));
    CHECK(row.at("ms_per_step").at("median") > 0);
    CHECK(row.at("crossings") == 0);
    CHECK(kernels_of(row, "step") != "");
    CHECK(kernels_of(row, "frame") != "");
    CHECK((kernels_of(row, "search") == "") == (method == "bvh"));
    if (method == "bvh") continue;
    CHECK(row.at("ms_per_search").at("median") > 0);
    CHECK(row.at("searches_per_frame") >= 1);
    CHECK(row.at("candidates") > 0);
    if (pose != "flat") CHECK(row.at("pairs") > 0);
    CHECK((row.at("contacts") > 0) == (pose != "flat"));
  }
  CHECK(rows ==
        "flat proximity_self, folded proximity_self, crumpled proximity_self, draped bvh, draped proximity, "
        "draped proximity_self, ");
}
