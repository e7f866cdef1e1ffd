#include <doctest/doctest.h>

#include "scene/load.hpp"
#include "session/describe.hpp"
#include "session/session.hpp"

using namespace weft;

#define REQUIRE_OK(expression)                                    \
  do {                                                            \
    const auto& ok_ = (expression);                               \
    REQUIRE_MESSAGE(static_cast<bool>(ok_), ok_.error().message); \
  } while (false)

namespace {

const SceneText kSheet{
    R"({ "format": "weft-scene/1", "solver": {"kind": "mass_spring"},
        "time": { "substeps": 4 }, "contact": { "method": "none" },
  "cloths": [{ "grid": [12, 10], "size": [1, 1], "plane": "xz", "density": 0.2, "pins": ["top"] }] })",
    "sheet",
    {}};

Result<Inputs> read_inputs(const SceneText& source) {
  WEFT_TRY(scene, scene::parse_scene(source.text, source.file, source.changes));
  WEFT_TRY(assets, load_assets(scene, std::string()));
  return Inputs{std::move(scene), std::move(assets)};
}

void open_and_load(Session& session) {
  const auto opened = session.open({});
  REQUIRE_OK(opened);
  const auto loaded = session.load(kSheet, read_inputs);
  REQUIRE_OK(loaded);
}

}  // namespace

TEST_CASE("what was loaded is described in one place") {
  Session session;
  open_and_load(session);
  const Description about = describe(*session.world());
  CHECK(about.nodes == 120);
  CHECK(about.triangles == 2 * 11 * 9);
  CHECK(about.springs == 11 * 10 + 12 * 9 + 2 * 11 * 9 + 10 * 10 + 12 * 8);  // structural, shear, bend
  CHECK(about.substeps == 4);
  CHECK(about.step_seconds == doctest::Approx(about.frame_seconds / 4));
  CHECK(about.solver == "mass_spring");
  CHECK(about.contact_method == "none");
}

TEST_CASE("a scene that cannot be loaded leaves no world, and the next one can") {
  Session session;
  open_and_load(session);
  SceneText bad = kSheet;
  bad.changes.push_back({"cloths.0.density", "-1"});
  CHECK(session.load(bad, read_inputs).error().kind == ErrorKind::Input);
  CHECK(session.world() == nullptr);
  const auto again = session.load(kSheet, read_inputs);
  REQUIRE_OK(again);
  CHECK(session.world() != nullptr);
}

TEST_CASE("a change that is refused is forgotten") {
  Session session;
  open_and_load(session);
  CHECK(!session.set("cloths.0.density", "0.3"));
  CHECK(!session.set("drag", "\"much\""));
  const auto changed = session.set("gravity", "[0, -1.62, 0]");  // read with all changes so far
  REQUIRE_OK(changed);
  CHECK(session.world()->scene().gravity.y == -1.62);
  CHECK(session.world()->scene().cloths[0].density == 0.2);
}

TEST_CASE("kernels are timed without a trace in the state") {
  Session session;
  open_and_load(session);
  CHECK(session.time_passes().error().kind == ErrorKind::Failure);  // nothing was simulated
  REQUIRE_OK(session.advance(false));
  const auto finished = session.world()->finish();
  REQUIRE_OK(finished);
  REQUIRE_OK(session.take_snapshot());
  const std::vector<Vec4f> before = session.snapshot().position;
  const auto times = session.time_passes();
  REQUIRE_OK(times);
  CHECK(times->empty() == !session.device().has_timestamps());
  REQUIRE_OK(session.take_snapshot());
  CHECK(session.snapshot().position == before);
}

TEST_CASE("the shape is exported in three formats, and no fourth") {
  Session session;
  open_and_load(session);
  for (const char* format : {"obj", "ply", "glb"}) {
    const auto written = session.export_mesh(format);
    REQUIRE_OK(written);
    CHECK(session.exported().size() > 120 * 3 * 4);
  }
  CHECK(session.export_mesh("stl").error().message ==
        "The format stl is not known; there are obj, ply and glb.");
}
