// Which method "auto" takes.
#include <doctest/doctest.h>

#include <string>

#include "mesh/grid.hpp"
#include "method/method.hpp"
#include "scene/load.hpp"

using namespace weft;
using Kind = scene::SolverKind;

namespace {

/// A sheet of 2 m, as a grid or as its triangles, with these further keys of the scene.
Result<MethodChoice> choice_for(std::uint32_t side, bool as_mesh, const std::string& keys) {
  const std::string count = std::to_string(side);
  const std::string shape =
      as_mesh ? R"("mesh": "sheet")" : R"("grid": [)" + count + "," + count + R"(], "size": [2, 2])";
  const auto scene =
      scene::parse_scene(R"({"format": "weft-scene/1", "cloths": [{"density": 0.2, "damping": 0.001, )" +
                             shape + "}]" + keys + "}",
                         "test.json");
  REQUIRE_MESSAGE(scene, scene.error().message);
  mesh::TriangleMesh sheet;
  if (as_mesh) {
    const mesh::Grid grid{side, side, 2, 2};
    sheet.triangles = mesh::grid_triangles(grid);
    for (std::uint32_t j = 0; j < side; ++j)
      for (std::uint32_t i = 0; i < side; ++i) {
        const mesh::RestPoint at = mesh::rest_point(grid, i, j);
        sheet.positions.push_back(Vec3f{static_cast<float>(at.x), static_cast<float>(at.y), 0});
      }
  }
  const auto model = build_model(*scene, {sheet});
  REQUIRE_MESSAGE(model, model.error().message);
  return choose_method(*scene, *model);
}

Kind kind_for(std::uint32_t side, bool as_mesh, const std::string& keys) {
  const auto choice = choice_for(side, as_mesh, keys);
  REQUIRE_MESSAGE(choice, choice.error().message);
  CHECK(choice->reason.find("a frame is predicted to take ") == 0);
  return choice->method->kind;
}

constexpr const char* kFree = R"(, "contact": {"method": "none"})";
constexpr const char* kContact = "";  // the default

}  // namespace

TEST_CASE("auto takes explicit steps for coarse cloth and implicit ones for fine cloth, grid or mesh") {
  for (const bool as_mesh : {false, true}) {
    CAPTURE(as_mesh);
    CHECK(kind_for(16, as_mesh, kFree) == Kind::MassSpring);
    CHECK(kind_for(16, as_mesh, kContact) == Kind::MassSpring);
    CHECK(kind_for(256, as_mesh, kContact) == Kind::Multigrid);
  }
  CHECK(kind_for(1000, false, kFree) == Kind::Multigrid);
}

TEST_CASE("once fine enough for implicit steps, finer cloth is too, and contact makes that come sooner") {
  for (const bool as_mesh : {false, true}) {
    std::uint32_t first[2] = {};  // the first side with implicit steps; 0: none
    for (const char* contact : {kFree, kContact}) {
      std::uint32_t& own = first[contact == kContact];
      for (const std::uint32_t side : {8U, 16U, 32U, 64U, 128U, 256U}) {
        const bool is_implicit = kind_for(side, as_mesh, contact) == Kind::Multigrid;
        CAPTURE(side);
        CHECK((own == 0 || is_implicit));
        if (own == 0 && is_implicit) own = side;
      }
    }
    CHECK(first[1] != 0);
    CHECK((first[0] == 0 || first[1] <= first[0]));
  }
}

TEST_CASE("auto takes no method that would blow up in the scene's substeps") {
  CHECK(kind_for(16, false, R"(, "time": {"substeps": 500}, "contact": {"method": "none"})") ==
        Kind::MassSpring);
  CHECK(kind_for(16, false, R"(, "time": {"substeps": 1}, "contact": {"method": "none"})") ==
        Kind::Multigrid);
}

TEST_CASE("auto takes the method that keeps a strain limit, however coarse the cloth") {
  for (const char* fabric : {"", R"(, "fabric": {"warp": 9, "shear": 3, "bending_warp": 0})"}) {
    const auto scene = scene::parse_scene(
        R"({"format": "weft-scene/1", "cloths": [{"grid": [4, 4], "size": [1, 1], "density": 0.2,
            "strain_limit": 0.1)" +
            std::string(fabric) + "}]}",
        "test.json");
    REQUIRE_MESSAGE(scene, scene.error().message);
    const auto model = build_model(*scene, {{}});
    REQUIRE_MESSAGE(model, model.error().message);
    const auto choice = choose_method(*scene, *model);
    REQUIRE_MESSAGE(choice, choice.error().message);
    CHECK(choice->method->kind == Kind::Multigrid);
  }
}

TEST_CASE(
    "implicit steps are 1/480 s long, by contact 1/360 s, and 1/1920 s where impulses answer all of it") {
  const std::string implicit = R"(, "solver": {"kind": "multigrid"})";
  const auto substeps = [&](const std::string& keys) {
    const auto choice = choice_for(16, false, implicit + keys);
    REQUIRE_MESSAGE(choice, choice.error().message);
    return choice->substeps;
  };
  CHECK(substeps(kFree) == 8);
  CHECK(substeps(kContact) == 6);
  CHECK(substeps(R"(, "contact": {"self": false})") == 8);        // there is nothing to meet
  CHECK(substeps(R"(, "contact": {"restitution": 0.5})") == 32);  // impulses answer all
  CHECK(substeps(R"(, "contact": {"restitution": 0.5, "self": false})") == 8);
}

TEST_CASE("auto refuses tethers by its own name, with what it would take and what keeps them") {
  for (const std::uint32_t side : {8U, 1000U}) {
    const auto scene = scene::parse_scene(
        R"({"format": "weft-scene/1", "cloths": [{"grid": [)" + std::to_string(side) + ", " +
            std::to_string(side) + R"(], "size": [2, 2], "density": 0.2, "pins": ["top"], "tethers": {}}]})",
        "test.json");
    REQUIRE_MESSAGE(scene, scene.error().message);
    const auto model = build_model(*scene, {{}});
    REQUIRE_MESSAGE(model, model.error().message);
    const auto choice = choose_method(*scene, *model);
    REQUIRE_FALSE(choice);
    CHECK(choice.error().message ==
          std::string(
              "test.json: cloths[0].tethers has a slack of 0, and solver.kind \"auto\", which takes \"") +
              (side == 8 ? "mass_spring" : "multigrid") +
              "\" here, keeps no tethers; \"xpbd\" or \"pbd\" does.");
  }
}

TEST_CASE("auto is what a scene without a kind gets, and its reason has the time predicted for each method") {
  const auto unsaid = choice_for(64, false, "");
  const auto said =
      choice_for(64, false, R"(, "solver": {"kind": "auto", "residual": 0.1, "forces": "node_centric"})");
  REQUIRE(unsaid);
  REQUIRE(said);
  CHECK(unsaid->reason == said->reason);
  for (const char* name : {"multigrid ", "mass_spring "})
    CHECK(unsaid->reason.find(name) != std::string::npos);
  CHECK(unsaid->reason.find("xpbd") == std::string::npos);
}

TEST_CASE("a kind that the scene names needs no reason") {
  for (const char* kind : {"multigrid", "mass_spring", "xpbd"}) {
    const auto choice = choice_for(4, false, std::string(R"(, "solver": {"kind": ")") + kind + R"("})");
    REQUIRE(choice);
    CHECK(scene::name_of(choice->method->kind) == std::string(kind));
    CHECK(choice->reason.empty());
  }
}

TEST_CASE("where no method can step a scene auto says why") {
  // So stiff that explicit steps need more than 65,536 a frame, and so long a frame that implicit ones do, too.
  const auto choice = choice_for(64, false, R"(, "time": {"frame": 10}, "solver": {"kind": "mass_spring"})");
  REQUIRE(!choice);
  CHECK(choice.error().kind == ErrorKind::Limit);
  CHECK(choice_for(64, false, R"(, "time": {"frame": 10})")->method->kind == Kind::Multigrid);
}
