// The broad phase of weft beside Embree's, on the same processor: the same pairs, asserted, and the times of
// both in one run. Prints a table; `bench_embree FILE` writes it as JSON too. Run it on a software adapter,
// or it compares two machines.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/file.hpp"
#include "bench/folds.hpp"
#include "bench/measure.hpp"
#include "bench/round_object.hpp"
#include "embree_search.hpp"
#include "scene/load.hpp"
#include "state/hash_pair.hpp"
#include "weft_search.hpp"

namespace weft {
namespace {

constexpr std::uint32_t kRoom = 10000000, kLayers = 8;
constexpr double kBudget = 6000;  // ms for a case, in rounds of all that is compared

Result<SearchCase> make_case(const std::string& cloth, std::vector<mesh::TriangleMesh> cloths,
                             double thickness) {
  WEFT_TRY(scene, scene::parse_scene(
                      R"({"format": "weft-scene/1", "contact": {"method": "proximity", "thickness": )" +
                          std::to_string(thickness) + R"(}, "cloths": [{)" + cloth +
                          R"(, "density": 0.3, "stiffness": {"structural": 300}}]})",
                      "bench embree"));
  SearchCase made;
  WEFT_TRY(model, build_model(scene, cloths));
  made.model = std::move(model);
  for (const Vec3d& p : made.model.rest_position) made.positions.push_back(p.to<float>());
  WEFT_TRY(lengths, contact::proximity_lengths(made.model, scene.contact));
  made.reach = static_cast<float>(lengths.least_reach);
  made.flat_reach = static_cast<float>(lengths.most_reach);
  made.thickness = static_cast<float>(lengths.self_thickness);
  return made;
}

enum class Pose { Flat, Folded, Crumpled };

Result<SearchCase> self_case(std::uint32_t side, Pose pose) {
  const std::string count = std::to_string(side);
  WEFT_TRY(made, make_case(R"("grid": [)" + count + "," + count + R"(], "size": [1, 1], "plane": "xz")",
                           std::vector<mesh::TriangleMesh>(1), 0.005));
  made.pose = pose == Pose::Flat ? "flat" : pose == Pose::Folded ? "folded" : "crumpled";
  if (pose == Pose::Flat) return made;
  const double gap = made.thickness, spacing = 1.0 / (side - 1);
  const bench::Folds folds = pose == Pose::Folded ? bench::even_folds(1, gap, kLayers, 1)
                                                  : bench::crumpled_folds(1, 1.7 * gap, kLayers, 1, 1);
  made.positions.clear();
  for (const Vec3d& along : bench::fold_column(side, spacing, pose == Pose::Folded ? 0 : 0.1, 1))
    for (const Vec3d& across : bench::fold_profile(side, spacing, folds))
      made.positions.push_back((across + along).to<float>());
  return made;
}

Result<SearchCase> object_case(std::uint32_t side, std::uint32_t triangles) {
  constexpr double kThickness = 0.003;  // m
  WEFT_TRY(made, make_case(R"("mesh": "sheet")", {bench::make_round_sheet(side, 1, kThickness)}, kThickness));
  made.pose = "draped";
  made.thickness = static_cast<float>(kThickness);
  made.object = bench::make_round_object(triangles);
  return made;
}

/// Milliseconds, of each round.
class Times {
 public:
  template <class Work>
  void add(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    values_.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  bench::Timing timing() const {
    std::vector<double> sorted = values_;
    std::sort(sorted.begin(), sorted.end());
    return {sorted[sorted.size() / 2], sorted.front()};
  }

 private:
  std::vector<double> values_;
};

nlohmann::ordered_json json_of(const bench::Timing& timing) {
  return {{"median", timing.median}, {"min", timing.least}};
}

/// One of Embree's ways of following the sheet.
struct Rival {
  const char* name;
  EmbreeSearch search;
  Times update, collide;

  Rival(const char* name_, RTCDevice device, const SearchCase& query, const WeftSearch& weft,
        EmbreeSearch::Update update_)
      : name(name_), search(device, query, weft.order(), update_, kRoom) {}
  double total() const { return update.timing().median + collide.timing().median; }
};

Result<nlohmann::ordered_json> compare(gpu::Device& device, RTCDevice embree, const SearchCase& query) {
  WEFT_TRY(weft, WeftSearch::create(device, query, kRoom));
  Rival rivals[] = {{"refit", embree, query, weft, EmbreeSearch::Update::Refit},
                    {"build_fast", embree, query, weft, EmbreeSearch::Update::BuildFast},
                    {"build", embree, query, weft, EmbreeSearch::Update::Build}};
  WEFT_CHECK(weft.run());
  WEFT_TRY(pairs, weft.pairs());
  std::uint32_t hash = 0;
  for (const PairKey key : pairs)
    hash += hash_pair(static_cast<std::uint32_t>(key >> 32U), static_cast<std::uint32_t>(key));
  for (Rival& rival : rivals) {
    rival.search.update();
    rival.search.collide();
    const std::vector<PairKey> found = rival.search.pairs();
    if (found != pairs)
      return make_error(ErrorKind::Failure,
                        "Embree (%s) finds %zu pairs of the %s sheet, weft %zu, or others.", rival.name,
                        found.size(), query.pose.c_str(), pairs.size());
  }
  Times own;
  Result<void> ran;
  const auto start = std::chrono::steady_clock::now();
  const auto spent = [&] {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  };
  for (int round = 0; round < 3 || spent() < kBudget; ++round) {
    own.add([&] { ran = weft.run(); });
    WEFT_CHECK(ran);
    for (Rival& rival : rivals) {
      rival.update.add([&] { rival.search.update(); });
      rival.collide.add([&] { rival.search.collide(); });
    }
  }
  const Rival& best = *std::min_element(std::begin(rivals), std::end(rivals),
                                        [](const Rival& a, const Rival& b) { return a.total() < b.total(); });
  char text[9];
  std::snprintf(text, sizeof text, "%08x", hash);
  nlohmann::ordered_json row = {{"query", query.self() ? "self" : "object"},
                                {"pose", query.pose},
                                {"nodes", query.positions.size()},
                                {"cloth_triangles", query.model.triangles.size()},
                                {"object_triangles", query.object.triangles.size()},
                                {"pairs", pairs.size()},
                                {"pair_hash", text},
                                {"weft_ms", json_of(own.timing())}};
  for (const Rival& rival : rivals)
    row["embree_ms"][rival.name] = {{"update", json_of(rival.update.timing())},
                                    {"collide", json_of(rival.collide.timing())}};
  row["embree_best"] = best.name;
  row["ratio"] = own.timing().median / best.total();
  std::printf("%-9s %8zu %9zu %9zu  %s %9.2f %9.2f %9.2f %-10s %7.2f\n", query.pose.c_str(),
              query.positions.size(), query.object.triangles.size(), pairs.size(), text, own.timing().median,
              best.update.timing().median, best.collide.timing().median, best.name,
              own.timing().median / best.total());
  std::fflush(stdout);
  return row;
}

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  return "unknown";
}

Result<void> run(const std::string& json_file) {
  WEFT_TRY(device, gpu::Device::create());
  const unsigned int threads = std::thread::hardware_concurrency();
  RTCDevice embree = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
  rtcSetDeviceErrorFunction(
      embree,
      [](void*, RTCError, const char* message) {
        std::fprintf(stderr, "weft: Embree: %s\n", message);
        std::exit(1);
      },
      nullptr);
  nlohmann::ordered_json json = {{"bench", "embree"},
                                 {"processor", processor_name()},
                                 {"threads", threads},
                                 {"embree", RTC_VERSION_STRING},
                                 {"adapter", device->adapter().name},
                                 {"driver", device->adapter().driver},
                                 {"rows", nlohmann::ordered_json::array()}};
  std::printf("%s, %u threads; Embree %s; %s, %s\n", processor_name().c_str(), threads, RTC_VERSION_STRING,
              device->adapter().name.c_str(), device->adapter().driver.c_str());
  std::printf("%-9s %8s %9s %9s  %-8s %9s %9s %9s %-10s %7s\n", "pose", "nodes", "object", "pairs", "hash",
              "weft ms", "update ms", "collide", "Embree's", "ratio");
  const auto add = [&](Result<SearchCase> query) -> Result<void> {
    if (!query) return query.error();
    WEFT_TRY(row, compare(*device, embree, *query));
    json["rows"].push_back(row);
    return json_file.empty() ? Result<void>() : write_file(json_file, json.dump(1) + "\n");
  };
  for (const std::uint32_t side : {100U, 256U})
    for (const Pose pose : {Pose::Flat, Pose::Folded, Pose::Crumpled}) WEFT_CHECK(add(self_case(side, pose)));
  for (const std::uint32_t triangles : {10000U, 100000U, 1000000U})
    WEFT_CHECK(add(object_case(100, triangles)));
  for (const std::uint32_t triangles : {100000U, 1000000U}) WEFT_CHECK(add(object_case(256, triangles)));
  rtcReleaseDevice(embree);
  return {};
}

}  // namespace
}  // namespace weft

int main(int count, char** arguments) {
  const weft::Result<void> result = weft::run(count > 1 ? arguments[1] : "");
  if (!result) std::fprintf(stderr, "weft: %s\n", result.error().message.c_str());
  return result ? 0 : 1;
}
