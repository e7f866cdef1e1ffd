// What a method says of itself before there is a solver: one row each, which everybody asks. Host only.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/result.hpp"
#include "method/step_limit.hpp"
#include "model/model.hpp"
#include "scene/scene.hpp"

namespace weft {

/// Whether "auto" takes a method for a model, and why.
struct AutoVerdict {
  bool takes = false;
  std::string reason;  // completes "chosen since ..."; empty: what kept "auto" from the methods before it
};

/// What a solver asks of the GPU beside the state, for grids, measured at 32² to 256² nodes [bytes a node].
struct SolverMemory {
  double node = 0;            // in all
  double largest_buffer = 0;  // in its largest buffer
};

struct Method {
  scene::SolverKind kind;              // its word: scene::name_of(kind)
  std::span<const ElementKind> takes;  // elements of other kinds are refused: check_elements

  /// The largest stable step of a model; nothing in it where any step is stable.
  StepLimit (*step_limit)(const scene::Scene& scene, const Model& model);
  /// The limit of the same scene with another drag, without finding the spectrum again.
  StepLimit (*with_drag)(const StepLimit& limit, double drag);
  /// What time.substeps "auto" means. Errors  Limit: more than scenes allow.
  Result<std::uint32_t> (*auto_substeps)(const scene::Scene& scene, const StepLimit& limit);
  /// Null: "auto" never takes the method. The last row that has one takes every model.
  AutoVerdict (*auto_verdict)(const Model& model);
  SolverMemory (*memory)(const scene::Solver& settings);
  /// How its settings read in a summary; "" without settings.
  const char* (*settings_word)(const scene::Solver& settings);

  /// Every so-many substeps may search for pairs. Long steps need a search each: what is fast goes further in four of
  /// them than it may go unseen.
  std::uint32_t search_interval;
  /// Whether obstacles stand in its matrix (Stages::press).
  bool holds_obstacles;
  /// How many states before the current one it reads, for nodes whose velocity's w is 1.
  std::uint32_t history;
};

/// All methods, those that "auto" prefers first.
std::span<const Method> methods();
/// The row of a kind that is not Auto.
const Method& method_of(scene::SolverKind kind);

/// Which method a scene gets, and why if the scene leaves that open.
struct MethodChoice {
  const Method* method = nullptr;
  std::string reason;  // empty: the scene names it
};
MethodChoice choose_method(const scene::Scene& scene, const Model& model);

/// Errors  Input: a cloth has elements that the method does not take.
Result<void> check_elements(const scene::Scene& scene, const Model& model, const Method& method);

/// The substeps of a frame: the scene's, or what its "auto" means with this method.
/// Errors  Limit: more than scenes allow.
Result<std::uint32_t> choose_substeps(const scene::Scene& scene, const Method& method,
                                      const StepLimit& limit);

/// Whether obstacles stand in the matrix that the method solves in this scene. What bounces is left to impulses.
bool solves_with_obstacles(const scene::Scene& scene, const Method& method);

}  // namespace weft
