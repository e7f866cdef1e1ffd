// One scene of a law: a world, its state in double.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sim/world.hpp"
#include "validate/law.hpp"

namespace weft::validate {

inline constexpr double kGravity = 9.81;    // [m/s²]
inline constexpr double kDensity = 0.2;     // of every cloth here [kg/m²]
inline constexpr double kFrame = 1.0 / 60;  // of a trial that says nothing else [s]

/// A number as JSON.
std::string text_of(double value);

struct Moment {
  std::vector<Vec3d> position, velocity;  // [m], [m/s]
  std::vector<double> mass;               // 0: held [kg]

  Vec3d momentum() const;                            // [kg m/s]
  Vec3d angular_momentum(const Vec3d& about) const;  // [kg m²/s]
  Vec3d center() const;                              // of all mass [m]
  Vec3d mean_velocity() const;                       // of all mass [m/s]
  double total_mass() const;                         // [kg]
};

class Trial {
 public:
  /// A world from the members of a scene, JSON without format and solver. A cloth's mesh is `mesh`.
  /// Errors  of scenes and worlds.
  static Result<Trial> create(const Rig& rig, const std::string& members,
                              const mesh::TriangleMesh& mesh = {});

  Result<void> advance(std::uint32_t frames);
  Result<Moment> now();
  /// Puts every node where `change` has it, at the velocity that it gives.
  Result<void> change(const std::function<void(std::size_t node, Vec3d& place, Vec3d& velocity)>& change);
  /// Kinetic, elastic and gravitational [J].
  Result<double> energy();
  /// From the first to the third change of sign of `of` [s]; not a number if `frames` pass without a third.
  Result<double> period(std::uint32_t frames, const std::function<double(const Moment&)>& of);

  sim::World& world() { return *world_; }

 private:
  explicit Trial(std::unique_ptr<sim::World> world) : world_(std::move(world)) {}
  std::unique_ptr<sim::World> world_;
};

/// The part of a cloth that says what it is of.
struct Material {
  double modulus;         // along both axes [N/m]
  double bending = 0;     // [N·m]; springs have none
  double damping = 1e-4;  // of fabric [s]
  double shear = 0;       // 0: 0.4 of the modulus [N/m]
};
/// The members "density", and "fabric" or "stiffness" and "damping", of a cloth. Springs along the boundary have half
/// the stiffness, so without springs across its cells a strip of any width has it as its modulus.
std::string members_of(const Rig& rig, const Material& material);

/// "grid" and "size" of square cells.
std::string grid_of(std::uint32_t nx, std::uint32_t ny, double cell);
/// The name by which a trial's cloth has its mesh.
inline const std::string kMesh = R"("mesh": "sheet.obj")";

/// Least squares: the slope of y over x, with a constant.
double slope_of(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace weft::validate
