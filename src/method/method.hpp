// The properties of a method before a solver exists, one row per method. Host only.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/result.hpp"
#include "contact/rules/solved_contact.hpp"
#include "method/step_limit.hpp"
#include "model/model.hpp"
#include "scene/scene.hpp"

namespace weft {

/// What a substep takes by the nodes it moves, a straight line fitted to runs on one GPU. It is there to compare
/// methods: elsewhere each takes another time. Source: docs/solvers/multigrid.md, Auto.
struct StepCost {
  double step = 0;  // of a set of dispatches, whatever its nodes [ms]
  double node = 0;  // [ms]
};
struct MethodCost {
  StepCost grid, mesh, fabric;                          // without contact; fabric: on grids too
  StepCost grid_contact, mesh_contact, fabric_contact;  // what "proximity" adds to it
};

/// GPU memory of a solver besides the state, for grids, measured at 32² to 256² nodes [bytes per node].
struct SolverMemory {
  double node = 0;            // in all
  double largest_buffer = 0;  // in its largest buffer
};

/// By how many times its own stiffness an element of a cloth resists that nothing else pulls at, least and most.
struct StiffeningRange {
  double least = 1, most = 1;
};

struct Method {
  scene::SolverKind kind;                              // its word: scene::name_of(kind)
  std::span<const ElementKind> takes;                  // elements of other kinds are refused: check_elements
  std::span<const scene::FabricEnergy> energies = {};  // of fabric; others are refused; none: it takes all
  std::span<const scene::SolidEnergy> solid_energies = {};  // of bodies, likewise
  bool flat_fabric = false;  // whether fabric that resists bending and is curved or plastic is refused

  /// The largest stable step of a model; nothing in it where any step is stable.
  StepLimit (*step_limit)(const scene::Scene& scene, const Model& model);
  /// The limit of the same scene with another drag, without finding the spectrum again.
  StepLimit (*with_drag)(const StepLimit& limit, double drag);
  /// The value of time.substeps "auto". Errors  Limit: more than scenes allow.
  Result<std::uint32_t> (*auto_substeps)(const scene::Scene& scene, const StepLimit& limit);
  /// Null: "auto" never takes the method.
  const MethodCost* cost;
  SolverMemory (*memory)(const scene::Solver& settings);
  /// Null: cloth resists with the stiffness of its elements, as far as a step is solved.
  StiffeningRange (*stiffening)(const scene::Solver& settings, const Model& model, const Body& body,
                                double step);
  /// How its settings read in a summary; "" without settings.
  const char* (*settings_word)(const scene::Solver& settings);

  /// One in this many substeps may search for pairs. Long steps need a search each: fast vertices move further in four
  /// of them than it may go unseen.
  std::uint32_t search_interval;
  bool holds_obstacles;        // whether it answers obstacles itself (Stages::press)
  bool holds_pairs = false;    // and pairs of one cloth
  bool bounds_nodes = false;   // by bounds on where a node may go, not by springs
  bool sews_fabric = false;    // whether threads pull at fabric; at springs they do by all
  bool limits_strain = false;  // whether edges beyond a strain limit are stiffer
  bool tethers = false;        // whether nodes are kept within their tethers
  double even_poisson = 0.5;   // slender bodies with more come to rest late: docs/bodies.md, Limits
  /// How many states before the current one it reads, for nodes whose velocity's w is 1.
  std::uint32_t history;
  std::uint32_t order = 1;  // of its steps in time
  bool sweeps = false;      // over elements or nodes, in dozens of dispatches a substep
  /// Of the blow of a rigid body (blow_step.hpp), how long "auto" steps may be; 0: it feels all that comes.
  double blow_part = 0;
};

/// All methods.
std::span<const Method> methods();
/// Whether a method takes fabric of this energy.
bool takes_energy(const Method& method, scene::FabricEnergy energy);
/// The row of a kind that is not Auto.
const Method& method_of(scene::SolverKind kind);

/// The method of a scene, and how it steps.
struct MethodChoice {
  const Method* method = nullptr;
  StepLimit limit;
  std::uint32_t substeps = 1;  // of a frame
  std::string reason;          // why "auto" took it; empty: the scene names it
};
/// The method that the scene names; for "auto" the one whose frame is predicted to take least, of those that take the
/// elements and are stable in the scene's substeps.
/// `lightest_rigid` is the least mass of the scene's rigid bodies; 0: it has none [kg].
/// Errors  Input: a cloth has elements that the method does not take. Limit: "auto" needs more substeps than scenes
///         allow.
Result<MethodChoice> choose_method(const scene::Scene& scene, const Model& model, double lightest_rigid = 0);
/// What a frame of the method is predicted to take [ms].
double predicted_frame(const scene::Scene& scene, const Model& model, const Method& method,
                       std::uint32_t substeps);

/// What of contact the method answers itself in this scene.
SolvedContact solved_contact(const scene::Scene& scene, const Method& method);
/// Whether impulses answer obstacles that the method would answer itself, for a rigid body's sake, or for
/// restitution's, which no method answers that holds pairs of cloth too.
bool leaves_obstacles(const scene::Scene& scene, const Method& method);

}  // namespace weft
