// The oracle of the mass-spring kernels: the same steps as plain loops in double.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "base/vec.hpp"
#include "element/spring/law.hpp"
#include "method/gas_reference.hpp"
#include "method/mass_spring/reference/fabric.hpp"
#include "method/mass_spring/reference/solid.hpp"
#include "model/air_triangles.hpp"
#include "scene/scene.hpp"
#include "scene/wind.hpp"

namespace weft::reference {

struct SpringLink {
  std::uint32_t node_a = 0, node_b = 0;
  double rest_length = 0;  // [m]
  double stiffness = 0;    // [N/m]
  double damping = 0;      // [N·s/m]
  double longest = 0;      // beyond which the implicit solver's is stiffer [m]; 0: none

  spring::Law law() const { return spring::Law::of(rest_length, stiffness, longest); }
};

/// Three nodes in a row that resist bending: k/2 |x_a - 2 x_b + x_c|².
struct BendLink {
  std::uint32_t node_a = 0, node_b = 0, node_c = 0;
  double stiffness = 0;  // [N/m]
};

/// Nodes and springs; node i is kinematic where inverse_mass[i] is 0.
struct MassSpringSystem {
  std::vector<Vec3d> position, velocity;  // [m], [m/s]
  std::vector<double> inverse_mass;       // [1/kg]
  std::vector<SpringLink> springs;
  std::vector<BendLink> bending;
  std::vector<FabricCloth> fabrics;
  std::vector<SolidBody> solids;
  std::vector<EnclosedGas> gases;
  Vec3d acceleration;  // gravity and external force [m/s²]
  double drag = 0;     // [1/s]
  scene::WindField wind;
  std::optional<scene::Air> air;
  std::vector<AirTriangle> triangles;    // that it pushes on
  double time = 0;                       // [s]; advance counts it up
  std::map<std::uint32_t, Vec3d> grabs;  // nodes that are pulled, each to a point [m]
  double grab_rate = 0;                  // [1/s]
  double grab_speed = 0;                 // [m/s]
};

/// The force of every node's springs, of its resistance to bending, of fabric and of bodies with volume [N].
std::vector<Vec3d> spring_forces(const MassSpringSystem& system);
/// A substep begins: what bends leave for good, in all fabric.
void yield(MassSpringSystem& system);
/// That of the gas in closed cloths at these places [m], [N].
std::vector<Vec3d> gas_forces(const MassSpringSystem& system, std::span<const Vec3d> places);

/// The wind at a place and time [m/s].
Vec3d wind_at(const scene::WindField& wind, const Vec3d& place, double time);

/// How fast a node that is grabbed goes to its target; none: it is not grabbed [m/s].
std::optional<Vec3d> grab_velocity(const MassSpringSystem& system, std::size_t node);

/// One step of semi-implicit Euler under these forces [N]: v += dt (a + f/m - drag (v - w)), then x += dt v. A grabbed
/// node has v = rate (target - x), cut to the grabs' speed, instead. `left_by_drag` is the part of (a + ...) that acts:
/// 1 where drag is of the velocity at the start, 1 / (1 + dt drag) of that at the end.
void integrate(MassSpringSystem& system, const std::vector<Vec3d>& forces, double dt,
               double left_by_drag = 1);
/// The same under all forces of the system.
void advance(MassSpringSystem& system, double dt);

/// [J]
struct EnergySums {
  double kinetic = 0;     // of free nodes
  double potential = 0;   // of theirs in gravity and the external force, 0 at the origin
  double springs = 0;     // stretched and pressed
  double membranes = 0;   // of fabric, with its limited edges
  double bending = 0;     // of hinges, and of rows of nodes that springs do not hold plane
  double tetrahedra = 0;  // of bodies
  double gas = 0;         // of that in closed cloths and of the air around it, 0 at rest

  double total() const { return kinetic + potential + springs + membranes + bending + tetrahedra + gas; }
};
EnergySums energies(const MassSpringSystem& system);
/// Kinetic, elastic and gravitational energy [J].
inline double energy(const MassSpringSystem& system) { return energies(system).total(); }

}  // namespace weft::reference
