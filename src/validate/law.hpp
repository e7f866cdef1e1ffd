// What weft is held to: laws of mechanics in numbers that no part of weft computes.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "gpu/device.hpp"
#include "scene/scene.hpp"

namespace weft::validate {

/// How a value is held to what is expected of it.
enum class Bound { Near, AtMost, AtLeast };

/// One number of a law, as cloth of weft has it.
struct Measure {
  std::string what;      // of which cloth, in words
  std::string unit;      // "" of a pure number
  double value = 0;      // not a number: the cloth did not do what is measured
  double expected = 0;   // by the law
  double tolerance = 0;  // a part of what is expected, where that is not 0; else of the unit
  Bound bound = Bound::Near;

  bool holds() const;
};

/// Where laws are measured.
struct Rig {
  gpu::Device& device;
  scene::SolverKind solver;  // not Auto

  /// Whether cloth is of fabric; else of springs, for a solver that takes no other.
  bool takes_fabric() const;
  /// Whether fabric may have this energy.
  bool takes(scene::FabricEnergy energy) const;
};

struct Law {
  std::string_view name;       // for --only
  std::string_view statement;  // with its source
  bool of_fabric;              // needs moduli that no lattice of springs has
  Result<std::vector<Measure>> (*measure)(const Rig& rig);
  bool of_sweeps =
      true;  // false: a method that sweeps (Method::sweeps) is measured only where the law is named
};

/// All laws, in the order in which they are told.
std::span<const Law> laws();

/// What is told of one number.
struct Row {
  const Law* law = nullptr;
  scene::SolverKind solver = scene::SolverKind::Auto;
  Measure measure;
};
/// Measures the laws of these names, all where there are none, by one solver, and tells each number as it comes.
/// Errors  of `tell` and of worlds. Diverged is told as a number that is none.
Result<void> measure_laws(const Rig& rig, std::span<const std::string> names,
                          const std::function<Result<void>(const Row&)>& tell);

}  // namespace weft::validate
