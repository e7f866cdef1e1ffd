// Cloth that falls, swings and is thrown: times, momentum, energy.
#include <array>
#include <cmath>

#include "closed_forms/pattern_sheet.hpp"
#include "method/method.hpp"
#include "validate/laws.hpp"
#include "validate/trial.hpp"

namespace weft::validate {
namespace {

const double kPi = std::acos(-1.0);
const std::string kAlone = R"("contact": {"method": "none"}, )";
const std::string kWeightless = kAlone + R"("gravity": [0, 0, 0], )";

/// A sheet of irregular triangles, 0.3 m by 0.22 m, in its own middle.
mesh::TriangleMesh irregular_sheet() {
  PatternSheet sheet = pattern_sheet(Pattern::Irregular, 0.3, 15, 11);
  for (Vec3d& p : sheet.position) p -= Vec3d{sheet.length / 2, sheet.width / 2, 0};
  return sheet.triangle_mesh();
}
const std::string kThreads = R"("damping": 0, "stiffness": {"structural": 300, "shear": 100, "bend": 0.1})";
std::string sheet_members(const Rig& rig, const std::string& fabric) {
  return kMesh + R"(, "density": 0.2, )" + (rig.takes_fabric() ? R"("fabric": {)" + fabric + "}" : kThreads);
}
const std::string kWoven =
    R"("warp": 900, "weft": 300, "shear": 60, "poisson": 0.25, "bending_warp": 4e-4, "bending_weft": 1e-4)";

}  // namespace

Result<std::vector<Measure>> measure_fall(const Rig& rig) {
  std::vector<Measure> measures;
  for (const double drag : {0.0, 2.0}) {
    WEFT_TRY(trial, Trial::create(rig, kAlone + R"("drag": )" + text_of(drag) + R"(, "cloths": [{)" +
                                           grid_of(5, 4, 0.05) + ", " + members_of(rig, {300}) + "}]"));
    WEFT_TRY(start, trial.now());
    WEFT_CHECK(trial.advance(60));
    WEFT_TRY(end, trial.now());
    const double exact =
        drag == 0 ? kGravity / 2 : kGravity / drag * (1 - (1 - std::exp(-drag)) / drag);  // in 1 s
    measures.push_back({"sheet with a drag of " + text_of(drag) + "/s: fall in 1 s", "m",
                        start.center().y - end.center().y, exact, 0.01});
  }
  return measures;
}

Result<std::vector<Measure>> measure_chain(const Rig& rig) {
  constexpr double kLength = 0.45, kFirstZero = 2.404825557695773;  // of J0
  WEFT_TRY(trial, Trial::create(rig, kAlone + R"("cloths": [{)" + grid_of(2, 31, kLength / 30) + ", " +
                                         members_of(rig, {1500}) + R"(, "pins": ["top"]}])"));
  WEFT_TRY(rest, trial.now());
  WEFT_CHECK(trial.change([&](std::size_t, Vec3d& x, Vec3d&) {
    const double below = std::max(0.0, 1 - (rest.position[0].y - x.y) / kLength);
    x.z += 0.01 * kLength * std::cyl_bessel_j(0.0, kFirstZero * std::sqrt(below));
  }));
  WEFT_TRY(period, trial.period(120, [](const Moment& m) { return m.position.back().z; }));
  return std::vector<Measure>{{"rope of 0.45 m: period of its first mode", "s", period,
                               4 * kPi / kFirstZero * std::sqrt(kLength / kGravity), 0.02}};
}

Result<std::vector<Measure>> measure_pendulum(const Rig& rig) {
  constexpr double kLength = 0.4, kAngle = 0.1;
  WEFT_TRY(trial, Trial::create(rig, kAlone + R"("cloths": [{)" + grid_of(5, 9, kLength / 8) + ", " +
                                         members_of(rig, {5000, 5}) + R"(, "pins": ["top"]}])"));
  WEFT_TRY(rest, trial.now());
  WEFT_CHECK(trial.change([&](std::size_t, Vec3d& x, Vec3d&) {
    const double below = rest.position[0].y - x.y;
    x = {x.x, rest.position[0].y - below * std::cos(kAngle), below * std::sin(kAngle)};
  }));
  WEFT_TRY(period, trial.period(120, [](const Moment& m) { return m.position.back().z; }));
  return std::vector<Measure>{{"stiff sheet of 0.4 m that swings by 0.1 rad: period", "s", period,
                               2 * kPi * std::sqrt(2 * kLength / (3 * kGravity)) * (1 + kAngle * kAngle / 16),
                               0.02}};
}

Result<std::vector<Measure>> measure_wave(const Rig& rig) {
  constexpr double kLength = 0.5, kModulus = 5;
  WEFT_TRY(trial, Trial::create(rig, kWeightless + R"("time": {"frame": 0.005}, "cloths": [{)" +
                                         grid_of(21, 2, kLength / 20) + ", " +
                                         members_of(rig, {.modulus = kModulus, .damping = 0}) + "}]"));
  WEFT_CHECK(trial.change([&](std::size_t, Vec3d& x, Vec3d& v) {
    v.x = 0.02 * std::sin(kPi * x.x / kLength);
    x.x += 1e-4 * std::sin(kPi * x.x / kLength);  // not at a zero
  }));
  WEFT_TRY(period,
           trial.period(80, [&](const Moment& m) { return m.position[20].x - m.position[0].x - kLength; }));
  return std::vector<Measure>{{"free strip of 0.5 m, 5 N/m: period of its first wave along", "s", period,
                               2 * kLength / std::sqrt(kModulus / kDensity), 0.02}};
}

/// Sheets of one size, of each material that the solver takes.
struct ThrownSheet {
  std::string name, cloth;
  mesh::TriangleMesh mesh;
};
std::vector<ThrownSheet> thrown_sheets(const Rig& rig) {
  const std::string woven = kMesh + R"(, "density": 0.2, "fabric": {"damping": 0, )";
  std::vector<ThrownSheet> sheets = {
      {"springs, grid", grid_of(13, 10, 0.025) + R"(, "density": 0.2, )" + kThreads, {}},
      {"springs, mesh", kMesh + R"(, "density": 0.2, )" + kThreads, irregular_sheet()}};
  if (!rig.takes_fabric()) return sheets;
  sheets.push_back({"yarn", woven + kWoven + "}", irregular_sheet()});
  if (rig.takes(scene::FabricEnergy::Green))
    sheets.push_back({"green", woven + kWoven + R"(, "energy": "green"})", irregular_sheet()});
  if (rig.takes(scene::FabricEnergy::NeoHookean))
    sheets.push_back({"neo_hookean",
                      woven + R"("warp": 500, "shear": 200, "poisson": 0.25, "bending_warp": 3e-4,
                                 "energy": "neo_hookean"})",
                      irregular_sheet()});
  return sheets;
}

Result<std::vector<Measure>> measure_throw(const Rig& rig) {
  std::vector<Measure> measures;
  for (const ThrownSheet& sheet : thrown_sheets(rig)) {
    WEFT_TRY(trial, Trial::create(rig, kWeightless + R"("cloths": [{)" + sheet.cloth + "}]", sheet.mesh));
    WEFT_CHECK(trial.change([&](std::size_t, Vec3d& x, Vec3d& v) {  // it spins and waves, at up to 4 m/s
      v = cross(Vec3d{3, 5, 20}, x) + Vec3d{0, 0, 0.5 * std::sin(20 * x.x) * std::cos(15 * x.y)};
    }));
    WEFT_TRY(start, trial.now());
    WEFT_TRY(begun, trial.energy());
    double most = begun;
    for (int frame = 0; frame < 40; ++frame) {
      WEFT_CHECK(trial.advance(1));
      WEFT_TRY(left, trial.energy());
      most = std::max(most, left);
    }
    WEFT_TRY(end, trial.now());
    double squares = 0;
    for (std::size_t n = 0; n < start.mass.size(); ++n)
      squares += start.mass[n] * dot(start.velocity[n], start.velocity[n]);
    const double speeds = std::sqrt(start.total_mass() * squares);  // of momentum, if all went one way
    const Vec3d spin = start.angular_momentum(start.center());
    const std::string what = "thrown sheet, " + sheet.name;
    measures.push_back(
        {what + ": most energy by that of the start", "", most / begun, 1, 0.02, Bound::AtMost});
    measures.push_back({what + ": change of momentum by all speeds", "",
                        length(end.momentum() - start.momentum()) / speeds, 0, 0.02});
    measures.push_back({what + ": change of spin by itself", "",
                        length(end.angular_momentum(end.center()) - spin) / length(spin), 0, 0.02});
  }
  return measures;
}

Result<std::vector<Measure>> measure_order(const Rig& rig) {
  std::array<std::vector<Vec3d>, 4> ends;
  std::uint32_t substeps = 0;
  for (std::size_t level = 0; level < 4; ++level) {
    const std::string steps = level == 0 ? R"("auto")" : std::to_string(substeps << level);
    WEFT_TRY(trial, Trial::create(rig,
                                  kAlone + R"("time": {"substeps": )" + steps + R"(}, "cloths": [{)" +
                                      sheet_members(rig, R"("warp": 60, "shear": 20, "bending_warp": 2e-4)") +
                                      R"(, "pins": [{"near": {"point": [-0.15, 0.11, 0], "radius": 0.02}}],
                                         "transform": {"rotate": [0.70710678, 0, 0, 0.70710678]}}])",
                                  irregular_sheet()));
    substeps = level == 0 ? trial.world().substeps() : substeps;
    WEFT_CHECK(trial.advance(12));
    WEFT_TRY(end, trial.now());
    ends[level] = end.position;
  }
  std::array<double, 3> apart{};
  for (std::size_t level = 0; level < 3; ++level)
    for (std::size_t n = 0; n < ends[0].size(); ++n)
      apart[level] = std::max(apart[level], length(ends[level][n] - ends[level + 1][n]));
  return std::vector<Measure>{{"sheet that swings for 0.2 m: order in the step", "",
                               std::log2(apart[0] / apart[2]) / 2,
                               static_cast<double>(method_of(rig.solver).order), 0.15, Bound::AtLeast}};
}

}  // namespace weft::validate
