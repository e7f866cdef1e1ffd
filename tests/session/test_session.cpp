#include <doctest/doctest.h>

#include "read_inputs.hpp"
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

namespace {

/// A strip whose right end goes away from its left.
const SceneText kPulled{
    R"({ "format": "weft-scene/1", "gravity": [0, 0, 0], "contact": { "method": "none" }, "time": { "substeps": 64 },
        "solver": {"kind": "mass_spring"},
  "cloths": [{ "grid": [9, 5], "size": [0.24, 0.1], "density": 0.1, "strength": 20, "pins": ["left"], "damping": 0.01,
    "stiffness": { "structural": 200, "shear": 60, "bend": 0 },
    "motions": [{ "nodes": "right", "kind": "line", "direction": [1, 0, 0], "speed": 0.6 }] }] })",
    "strip",
    {}};

void tear(Session& session) {
  for (int frame = 0; frame < 40 && session.world()->tears().splits() == 0; ++frame) {
    const auto changed = session.change_mesh("test");
    REQUIRE_OK(changed);
    REQUIRE_OK(session.advance(false));
    const auto finished = session.world()->finish();
    REQUIRE_OK(finished);
  }
  REQUIRE(session.world()->tears().splits() > 0);
}

}  // namespace

TEST_CASE("a session whose cloth tears has the world made anew, says so once, and a reset makes it whole") {
  Session session;
  REQUIRE_OK(session.open({}));
  int worlds = 0;
  session.on_world([&](sim::World&) { ++worlds; });
  REQUIRE_OK(session.load(kPulled, read_inputs));
  CHECK(session.changes_mesh());
  CHECK(worlds == 1);
  const std::size_t whole = session.world()->model().vertex_count();
  tear(session);
  CHECK(worlds == 2);
  const std::size_t torn = session.world()->model().vertex_count();
  CHECK(torn > whole);
  const auto saved = session.save_state("test");
  REQUIRE_OK(saved);

  REQUIRE_OK(session.reset());
  CHECK(worlds == 3);
  CHECK(session.world()->model().vertex_count() == whole);
  CHECK(session.world()->tears().splits() == 0);
  CHECK(session.world()->frame() == 0);

  const auto opened = session.open_state(*saved, "test");
  REQUIRE_OK(opened);
  CHECK(opened->empty());
  CHECK(session.world()->model().vertex_count() == torn);
  REQUIRE_OK(session.take_snapshot());
  const std::string hash = session.snapshot().hash();
  std::vector<std::byte> cut(saved->begin(), saved->end() - 9);
  CHECK_FALSE(session.open_state(cut, "test"));
  REQUIRE_OK(session.take_snapshot());
  CHECK(session.snapshot().hash() == hash);
}

TEST_CASE("a session that loads a scene whose mesh stays as it is has nothing to change") {
  Session session;
  open_and_load(session);
  CHECK_FALSE(session.changes_mesh());
  const auto changed = session.change_mesh("test");
  REQUIRE_OK(changed);
  CHECK_FALSE(changed->changed);
  CHECK(changed->news.empty());
}
