#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "scene/fabrics.hpp"
#include "scene/load.hpp"
#include "scene/looks.hpp"
#include "texts.hpp"

using namespace weft;
using namespace weft::scene;

namespace {

/// The first cloth of a scene of one, or the message that refuses it.
Cloth read_cloth(const std::string& keys) {
  const auto scene = parse_scene(cloth_of(R"("grid": [4, 4], "size": [1, 1], )" + keys), "a.json");
  REQUIRE_MESSAGE(scene, scene.error().message);
  return scene->cloths.at(0);
}
std::string refusal(const std::string& keys) {
  const auto scene = parse_scene(cloth_of(R"("grid": [4, 4], "size": [1, 1], )" + keys), "a.json");
  REQUIRE_FALSE(scene);
  return scene.error().message;
}

std::array<Cited, 9> numbers_of(const NamedFabric& f) {
  return {f.density,      f.warp,         f.weft,          f.shear,   f.poisson,
          f.bending_warp, f.bending_weft, f.bending_twist, f.friction};
}

}  // namespace

TEST_CASE("a fabric's name brings its moduli, its density and its friction") {
  const NamedFabric& denim = *find_fabric("denim_11oz");
  for (const char* keys : {R"("fabric": "denim_11oz")", R"("fabric": {"name": "denim_11oz"})"}) {
    const Cloth cloth = read_cloth(keys);
    CHECK(cloth.fabric == moduli_of(denim));
    CHECK(cloth.fabric->name == "denim_11oz");
    CHECK(cloth.fabric->warp == denim.warp.value);
    CHECK(cloth.fabric->bending_twist == denim.bending_twist.value);
    CHECK(cloth.fabric->damping == Fabric{}.damping);
    CHECK(cloth.density == denim.density.value);
    CHECK(cloth.friction == denim.friction.value);
  }
}

TEST_CASE("what a scene gives goes before what a fabric's name brings") {
  const Cloth cloth = read_cloth(
      R"("density": 0.5, "friction": 0.9, "fabric": {"name": "blanket", "weft": 100, "poisson": 0.1,
         "bending_weft": 1e-6, "damping": 0.001, "energy": "green"})");
  const NamedFabric& blanket = *find_fabric("blanket");
  CHECK(cloth.density == 0.5);
  CHECK(cloth.friction == 0.9);
  CHECK(cloth.fabric->warp == blanket.warp.value);
  CHECK(cloth.fabric->weft == 100);
  CHECK(cloth.fabric->poisson == 0.1);
  CHECK(cloth.fabric->bending_warp == blanket.bending_warp.value);
  CHECK(cloth.fabric->bending_weft == 1e-6);
  CHECK(cloth.fabric->bending_twist == blanket.bending_twist.value);
  CHECK(cloth.fabric->damping == 0.001);
  CHECK(cloth.fabric->energy == FabricEnergy::Green);
  CHECK_FALSE(cloth.fabric->plastic);
  const Cloth kept = read_cloth(R"("fabric": {"name": "blanket", "plastic": {"yield_curvature": 40}})");
  CHECK(kept.fabric->plastic == Plastic{40, 0});
  const Cloth by_node = read_cloth(R"("node_mass": 0.01, "fabric": "blanket")");
  CHECK(by_node.node_mass == 0.01);
  CHECK_FALSE(by_node.density);
}

TEST_CASE("a wrong name of a fabric is refused with the nearest one") {
  for (const char* keys : {R"("fabric": "denim_10oz")", R"("fabric": {"name": "denim_10oz"})"}) {
    const std::string message = refusal(keys);
    CHECK(message.find("is \"denim_10oz\", not one of \"denim_11oz\"") != std::string::npos);
    CHECK(message.find("did you mean \"denim_11oz\"?") != std::string::npos);
  }
  CHECK(refusal(R"("density": 1, "fabric": 3)").find("cloths[0].fabric is 3, not one of") !=
        std::string::npos);
}

TEST_CASE("without a name a fabric needs its moduli and a mass as before") {
  CHECK(refusal(R"("fabric": {"warp": 1, "shear": 1, "bending_warp": 1})")
            .find("has neither \"density\" nor") != std::string::npos);
  CHECK(refusal(R"("density": 1, "fabric": {"warp": 1, "shear": 1})").find("bending_warp is missing") !=
        std::string::npos);
  CHECK(refusal(R"("density": 1, "node_mass": 1, "fabric": "blanket")").find("has both") !=
        std::string::npos);
  // What is changed must fit the rest.
  CHECK(refusal(R"("fabric": {"name": "blanket", "poisson": 3})")
            .find("poisson is 3; its square must be below") != std::string::npos);
}

TEST_CASE("every number of the table has a source that there is, or is a guess, and fits a scene") {
  std::set<std::string> sources;
  for (const FabricSource& source : kFabricSources) CHECK(sources.insert(source.id).second);
  REQUIRE(sources.count("guess") == 1);
  std::set<std::string> used, names;
  for (const NamedFabric& fabric : kFabrics) {
    CAPTURE(fabric.name);
    CHECK(names.insert(fabric.name).second);
    for (const Cited& number : numbers_of(fabric)) {
      CHECK(sources.count(number.source) == 1);
      used.insert(number.source);
    }
    CHECK(std::string(fabric.density.source) != "guess");  // else nothing of it was measured
    CHECK(std::string(fabric.bending_warp.source) != "guess");
    if (fabric.drape.source != nullptr) {
      CHECK(sources.count(fabric.drape.source) == 1);
      used.insert(fabric.drape.source);
      CHECK(fabric.drape.least <= fabric.drape.most);
      CHECK(fabric.drape.most < 100);
    }
    read_cloth(std::string(R"("fabric": ")") + fabric.name + "\"");  // the ranges of scenes hold
  }
  CHECK(used == sources);
  CHECK(names.size() >= 10);
}

TEST_CASE("every fabric of the table resists every strain and every curvature") {
  for (const NamedFabric& f : kFabrics) {
    CAPTURE(f.name);
    CHECK(f.warp.value > 0);
    CHECK(f.weft.value > 0);
    CHECK(f.shear.value > 0);
    CHECK(f.poisson.value * f.poisson.value < f.warp.value / f.weft.value);  // docs/elements.md, eq. 2
    CHECK(f.bending_warp.value > 0);
    CHECK(f.bending_weft.value > 0);
    CHECK(f.bending_twist.value > 0);
    // By kind of cloth, in any textbook: 50 g/m² is a chiffon and 500 a coat; bending lengths are 1 to 4 cm.
    CHECK(f.density.value > 0.05);
    CHECK(f.density.value < 0.5);
    for (const Cited& bending : {f.bending_warp, f.bending_weft}) {
      const double bending_length = std::cbrt(bending.value / (f.density.value * 9.81));
      CHECK(bending_length > 0.01);
      CHECK(bending_length < 0.04);
    }
  }
}

TEST_CASE("published rows become the moduli of strips that their file's own program would find") {
  // A strip that is free across: of energy (c11 x² + 2 c12 x y + c22 y²), which is half of 2 c, with x free, the stress
  // by y is 2 (c22 - c12²/c11), and x is -c12/c11 y.
  constexpr NamedFabric made = of_wang("a", "b", "c", {0.1, 10, 4, 20, 3, 8e-6, 8e-6, 8e-6}, kNoDrape, "");
  const double across = -0.4, energy = 10 * across * across + 2 * 4 * across + 20;
  CHECK(made.warp.value == doctest::Approx(2 * energy));  // the energy of y = 1 is half the modulus
  CHECK(made.poisson.value == doctest::Approx(0.4));
  CHECK(made.weft.value == doctest::Approx(2 * (10 - 16.0 / 20)));
  CHECK(made.shear.value == 3);
  CHECK(made.bending_warp.value == doctest::Approx(2e-6));
  CHECK(made.bending_twist.value == doctest::Approx(1e-6));  // of the same in every direction: half of B
}

TEST_CASE("a fabric's name brings a look, a look's name goes before it, and an object changes a part") {
  for (const NamedFabric& fabric : kFabrics) {
    const Cloth cloth = read_cloth("\"fabric\": \"" + std::string(fabric.name) + "\"");
    CHECK(cloth.look == look_of(look_of_fabric(fabric.name)));
    CHECK(cloth.look.name != "woven");
  }
  CHECK(read_cloth(R"("fabric": "denim_11oz", "look": "silk")").look == look_of("silk"));
  Look changed = look_of("denim");
  changed.sheen = 0.75;
  changed.weft = Vec3d{0.5, 0, 0};
  changed.pattern = Pattern::Stripes;
  changed.stripe = Vec3d{1, 1, 1};
  const std::string keys =
      R"("sheen": 0.75, "weft": [0.5, 0, 0], "pattern": "stripes", "stripe": [1, 1, 1]})";
  CHECK(read_cloth(R"("fabric": "denim_11oz", "look": {)" + keys).look == changed);
  CHECK(read_cloth(R"("density": 1, "look": {"name": "denim", )" + keys).look == changed);
  CHECK(read_cloth(R"("density": 1, "look": {"threads_per_cm": 9})").look.threads_per_cm == 9);
}

TEST_CASE("no motion follows from a look, a material and the light") {
  const auto content = [](const std::string& material, const std::string& look, const std::string& light) {
    const auto scene = parse_scene(R"({"format": "weft-scene/1", "cloths": [{"grid": [4, 4], "size": [1, 1],
        "density": 1)" + look + R"(}], "colliders": [{"kind": "sphere", "center": [0, 0, 0], "radius": 1)" +
                                       material + "}]" + light + "}",
                                   "a.json");
    REQUIRE_MESSAGE(scene, scene.error().message);
    return scene->content;
  };
  const std::uint64_t plain = content("", "", "");
  CHECK(content(R"(, "material": "metal")", "", "") == plain);
  CHECK(content("", R"(, "look": "velvet")", "") == plain);
  CHECK(content("", "", R"(, "render": {"light": {"environment": "sky"}})") == plain);
  CHECK(content(R"(, "friction": 0.5)", "", "") != plain);
}
