#include <doctest/doctest.h>

#include <map>
#include <sstream>

#include "weft.hpp"

using namespace weft;

namespace {

/// The columns of a file of numbers, by their names.
std::map<std::string, std::vector<double>> columns_of(const std::string& text) {
  std::istringstream lines(text);
  std::string line, word;
  REQUIRE(std::getline(lines, line));
  std::vector<std::string> names;
  for (std::istringstream words(line); std::getline(words, word, ',');) names.push_back(word);
  std::map<std::string, std::vector<double>> columns;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    for (const std::string& name : names) {
      REQUIRE(std::getline(words, word, ','));
      columns[name].push_back(std::stod(word));
    }
  }
  return columns;
}

/// The rows of a run of this scene without pictures.
std::map<std::string, std::vector<double>> rows_of(const std::string& scene,
                                                   std::vector<std::string> more = {}) {
  const TemporaryFolder folder;
  more.insert(more.begin(),
              {"run", put(folder, "a.json", scene), "-o", folder.path("out"), "--no-pictures", "-q"});
  const Ended ended = run_weft(more);
  REQUIRE_MESSAGE(ended.code == 0, ended.err);
  return columns_of(read_text(folder.path("out/frames.csv")));
}

}  // namespace

TEST_CASE("what falls freely gains the kinetic energy that it loses in height, and its elements stay empty") {
  // 0.3 kg/m² on 0.4 m by 0.5 m, 0.06 kg, from a height of 2 m.
  for (const char* elements :
       {R"("stiffness": {"structural": 40, "shear": 10, "bend": 0.3})", R"("fabric": "denim_11oz")"}) {
    CAPTURE(elements);
    auto rows = rows_of(std::string(R"({"format": "weft-scene/1", "time": {"substeps": 20, "frames": 12},
        "solver": {"kind": "multigrid"}, "contact": {"method": "none"},
        "cloths": [{"grid": [7, 6], "size": [0.4, 0.5], "plane": "xz", "density": 0.3, )") +
                        elements + R"(, "transform": {"translate": [0, 2, 0]}}]})");
    REQUIRE(rows["frame"].size() == 12);
    const double weight = 0.06 * 9.81;
    for (std::size_t frame = 0; frame < 12; ++frame) {
      const double time = (static_cast<double>(frame) + 1) / 60, speed = 9.81 * time;
      CHECK(rows["frame"][frame] == static_cast<double>(frame));
      CHECK(rows["time_s"][frame] == doctest::Approx(time));
      CHECK(rows["kinetic_J"][frame] == doctest::Approx(0.03 * speed * speed).epsilon(1e-4));
      // A substep of 1/1200 s may be a substep's speed ahead or behind.
      CHECK(rows["potential_J"][frame] == doctest::Approx(weight * (2 - speed * time / 2)).epsilon(1e-3));
      for (const char* kind : {"springs_J", "membranes_J", "bending_J", "tetrahedra_J"})
        CHECK(rows[kind][frame] == doctest::Approx(0).epsilon(1e-7).scale(1));
      CHECK(rows["stretch_999"][frame] == doctest::Approx(1).epsilon(1e-4));
    }
  }
}

TEST_CASE("a strip that hangs from an end stores what half its weight does on the way that it stretches") {
  // A chain of 2 x 9 nodes, 0.8 m, 100 N/m a thread: at rest, after much drag, springs hold half of what weight gave.
  auto rows = rows_of(R"({"format": "weft-scene/1", "time": {"substeps": 64, "frames": 150}, "drag": 8,
      "solver": {"kind": "mass_spring"}, "contact": {"method": "none"},
      "cloths": [{"grid": [2, 9], "size": [0.1, 0.8], "density": 1, "damping": 0.1, "pins": ["top"],
                  "stiffness": {"structural": 100, "shear": 0, "bend": 0}}]})");
  const double first = rows["potential_J"].front(), last = rows["potential_J"].back();
  CHECK(rows["kinetic_J"].back() < 1e-6);
  CHECK(rows["springs_J"].back() > 0.005);
  CHECK(rows["springs_J"].back() == doctest::Approx((first - last) / 2).epsilon(0.02));
  CHECK(rows["max_stretch"].back() >= rows["stretch_999"].back());
  CHECK(rows["max_stretch"].back() > 1.01);
}

TEST_CASE("a strip that keeps all bends has no energy of bending, and none that rises") {
  // It yields from a bend of 1 m on, without hardening: its hinges keep what one substep bends them by.
  auto rows = rows_of(R"({"format": "weft-scene/1", "time": {"frames": 30}, "solver": {"kind": "multigrid"},
      "contact": {"method": "none"},
      "cloths": [{"grid": [9, 5], "size": [0.4, 0.2], "plane": "xz", "density": 0.2,
                  "pins": ["left", {"box": {"min": [-0.16, -1, -1], "max": [-0.14, 1, 1]}}],
                  "fabric": {"warp": 400, "weft": 200, "shear": 80, "bending_warp": 0.002, "bending_weft": 0.0002,
                             "damping": 0.0001, "plastic": {"yield_curvature": 0.001, "hardening": 0}}}]})");
  REQUIRE(rows["frame"].size() == 30);
  double lowest = 0;
  for (std::size_t frame = 0; frame < 30; ++frame) {
    const double fallen = -rows["potential_J"][frame];
    lowest = std::max(lowest, fallen);
    CHECK(rows["bending_J"][frame] < 0.01 * std::max(fallen, 1e-3));
    CHECK(rows["kinetic_J"][frame] + rows["membranes_J"][frame] + rows["bending_J"][frame] <
          1.001 * fallen + 1e-6);
  }
  CHECK(lowest > 0.015);  // J: it hangs down
}

TEST_CASE("rows have where a rigid body is and how fast: it falls by g t, and spins on") {
  auto rows = rows_of(
      R"({"format": "weft-scene/1", "time": {"substeps": 4, "frames": 6}, "solver": {"kind": "mass_spring"},
      "cloths": [{"grid": [2, 2], "size": [0.1, 0.1], "density": 0.2, "pins": ["corners"]}],
      "colliders": [{"kind": "plane", "point": [0, -5, 0], "normal": [0, 1, 0]},
                    {"kind": "sphere", "center": [1, 2, 3], "radius": 0.1,
                     "rigid": {"mass": 1, "velocity": [0.5, 0, 0], "spin": [0, 0, 7]}}]})");
  REQUIRE(rows["frame"].size() == 6);
  for (std::size_t frame = 0; frame < 6; ++frame) {
    const double t = static_cast<double>(frame + 1) / 60;
    CHECK(rows["collider_1_x_m"][frame] == doctest::Approx(1 + 0.5 * t).epsilon(1e-6));
    CHECK(rows["collider_1_y_m"][frame] ==
          doctest::Approx(2 - 0.5 * 9.81 * t * (t + 1.0 / 240)).epsilon(1e-6));
    CHECK(rows["collider_1_vy_m_s"][frame] == doctest::Approx(-9.81 * t).epsilon(1e-5));
    CHECK(rows["collider_1_wz_rad_s"][frame] == doctest::Approx(7).epsilon(1e-5));
  }
  CHECK(rows.count("collider_0_x_m") == 0);
}

TEST_CASE("a ball of gas that breathes hands its energy to and fro, and its rows have volume and pressure") {
  auto rows = rows_of(
      R"({"format": "weft-scene/1", "gravity": [0, 0, 0], "time": {"frame": 0.001, "substeps": 50, "frames": 30},
      "solver": {"kind": "mass_spring"}, "contact": {"method": "none"},
      "cloths": [{"grid": [3, 3], "size": [0.1, 0.1], "density": 0.2},
                 {"mesh": "sphere", "transform": {"scale": 0.3}, "density": 0.2,
                  "pressure": {"gauge": 8000, "ambient": 20000},
                  "fabric": {"warp": 2000, "shear": 800, "bending_warp": 0, "damping": 0}}]})");
  REQUIRE(rows["frame"].size() == 30);
  double least = 0, most = 0, volume = rows["cloth_1_volume_m3"][0];
  for (std::size_t frame = 0; frame < 30; ++frame) {
    const double inside = rows["cloth_1_gauge_Pa"][frame] + 20000;
    CHECK(
        inside * rows["cloth_1_volume_m3"][frame] ==
        doctest::Approx((rows["cloth_1_gauge_Pa"][0] + 20000) * rows["cloth_1_volume_m3"][0]).epsilon(1e-6));
    least = std::min(least, rows["gas_J"][frame]);
    most = std::max(most, rows["kinetic_J"][frame] + rows["membranes_J"][frame]);
    volume = std::max(volume, rows["cloth_1_volume_m3"][frame]);
    // Semi-implicit Euler is off by h ω/2 of what is exchanged: by 0.013 where h is 20 µs and ω² is
    // (3 p0/R + 2 E/R²)/σ.
    CHECK(std::abs(rows["gas_J"][frame] + rows["kinetic_J"][frame] + rows["membranes_J"][frame]) <
          2 * 0.013 * most);
  }
  CHECK(least < -1);
  CHECK(most > 1);
  CHECK(volume > 1.2 * 0.1106);  // of that at rest
  CHECK(rows.count("cloth_0_volume_m3") == 0);
}

TEST_CASE("rows sum up to the summary, and take no read-back where no measures are wanted") {
  const TemporaryFolder folder;
  const std::string scene =
      put(folder, "a.json", R"({"format": "weft-scene/1", "time": {"substeps": 3, "frames": 6},
      "solver": {"kind": "multigrid"}, "contact": {"method": "proximity", "thickness": 0.01},
      "cloths": [{"grid": [9, 8], "size": [0.4, 0.4], "plane": "xz", "density": 0.3,
                  "transform": {"translate": [0, 0.11, 0]}}],
      "colliders": [{"kind": "sphere", "center": [0.01, 0, 0], "radius": 0.1}]})");
  const Ended ended =
      run_weft({"run", scene, "-o", folder.path("out"), "--no-pictures", "--no-measures", "--json"});
  REQUIRE(ended.code == 0);
  auto rows = columns_of(read_text(folder.path("out/frames.csv")));
  const auto summary = json_of(ended.out);
  CHECK(rows.count("kinetic_J") == 0);
  CHECK(rows.count("stretch_999") == 0);
  double contacts = 0, residual = 0;
  for (const double one : rows["contacts"]) contacts += one;
  for (const double one : rows["residual"]) residual = std::max(residual, one);
  CHECK(contacts > 0);
  CHECK(contacts == summary.at("contacts").get<double>());
  CHECK(residual == summary.at("residual").get<double>());
  // Rows of other columns are not gone on with.
  const std::string checkpoint = folder.path("c/checkpoint_00003.weft");
  REQUIRE(run_weft({"run", scene, "-o", folder.path("c"), "--no-pictures", "--checkpoint-every", "3"}).code ==
          0);
  const Ended resumed = run_weft(
      {"run", scene, "-o", folder.path("c"), "--no-pictures", "--no-measures", "--resume", checkpoint});
  CHECK(resumed.code == 0);
  CHECK(resumed.err ==
        "weft: The rows of " + folder.path("c/frames.csv") + " are of other columns, and are removed.\n");
  CHECK(columns_of(read_text(folder.path("c/frames.csv")))["frame"] == std::vector<double>{3, 4, 5});
}
