// What was loaded, as one record for the command line, the page and the public interface.
#pragma once

#include "scene/names.hpp"
#include "sim/world.hpp"
#include "weft/report.hpp"

namespace weft {

/// `Running` is a sim::World or a reference::Simulation.
template <class Running>
Description describe(const Running& running, std::uint64_t nodes, std::uint64_t triangles,
                     std::uint64_t dropped_triangles) {
  const scene::Scene& scene = running.scene();
  const Method& method = running.plan().method();
  Description made;
  made.nodes = nodes;
  made.triangles = triangles;
  made.springs = running.element_count(ElementKind::Spring);
  made.membranes = running.element_count(ElementKind::Membrane);
  made.hinges = running.element_count(ElementKind::Hinge);
  made.slivers = running.sliver_count();
  made.tetrahedra = running.element_count(ElementKind::Tet);
  made.dropped_triangles = dropped_triangles;
  made.solver = scene::name_of(method.kind);
  made.solver_reason = running.plan().reason();
  made.solver_settings = method.settings_word(scene.solver);
  made.contact_method = scene::name_of(scene.contact.method);
  made.frames = scene.time.frames;
  made.substeps = running.substeps();
  made.frame_seconds = scene.time.frame;
  made.step_seconds = running.step();
  made.stable_step_seconds = running.plan().limit().largest_step;
  made.unstable_step = unstable_step(running.plan().limit(), scene.time.frame, running.substeps());
  return made;
}

inline Description describe(const sim::World& world) {
  return describe(world, world.model().vertex_count(), world.model().triangle_count(),
                  world.assets().dropped_triangles);
}

}  // namespace weft
