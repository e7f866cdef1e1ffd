// Answers pairs that are near: the impulses and pushes of docs/contact.md, equations (1) to (5), in double.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/mat3.hpp"
#include "contact/reference/proximity/rigid.hpp"
#include "contact/rules/contact_law.hpp"
#include "contact/rules/yielding_edges.hpp"

namespace weft::reference {

/// The axis of a sphere or capsule; both ends of a sphere's are its centre.
struct RoundAxis {
  std::array<Vec3d, 2> start, end;  // its ends, at the start and at the end of the substep [m]
};

/// What the mesh of a pair stands for: a smooth surface, at a place on it.
struct CurvedSurface {
  Vec3d place;           // p, of cloth: the pair's closest point, at the start of the substep [m]
  Mat3 shape;            // S = dn/dx, with the normal toward cloth [1/m]
  Vec3d velocity, spin;  // o of the surface there [m/s]; of the mesh [rad/s]
};

/// A pair of features as its impulse sees it.
struct NearPair {
  std::uint32_t node_count = 0;          // of cloth
  std::array<std::uint32_t, 4> nodes{};  // of side A, then of side B
  std::array<double, 4> weights{};       // w, with their signs
  Vec3d direction;                       // n
  double distance = 0;                   // d [m]
  double thickness = 0;                  // h, or h_s for cloth with cloth [m]
  double friction = 0;                   // μ
  Vec3d surface;           // Σ w v over an obstacle's side: its velocity o, or -o where it is side B [m/s]
  Vec3d kept;              // the force with which it ended the substep before [N]
  bool may = true;         // false: another pair is nearer, FeaturePair::inside and in_cones; never acts
  bool with_body = false;  // one side is an obstacle
  bool held = false;       // the solver's matrix has answered it
  bool solved = false;     // the same of cloth with cloth: `kept` is the force that it has now
  bool untangles =
      false;  // it separates features on the wrong side, equation (7); d: minus the part of that speed
  bool of_one_system = false;           // are_of_one_system
  bool of_bodies = false;               // of these, features of bodies with volume
  bool of_two_bodies = false;           // of these, of two
  std::optional<RoundAxis> round;       // of the obstacle
  std::optional<CurvedSurface> curved;  // likewise
  /// Of a rigid body, which the pair's impulse moves.
  struct Rigid {
    std::size_t collider = 0;
    double weight = 0;  // 1: it is side A; -1: side B
    Vec3d arm;          // from its centre, where its way ends, to the pair's place on cloth [m]
  };
  std::optional<Rigid> rigid;
};

struct ContactLaw {
  double dt = 0;           // [s]
  double restitution = 0;  // e
  Vec3d load;              // a: of gravity and the external force [m/s²]
  ImpulseRule impulses;
  PushTimes push_times;
};

struct Response {
  std::vector<Vec3d> change;                // of each node's velocity [m/s]
  std::vector<Vec3d> push;                  // of each node's place, which is not in its velocity [m]
  std::vector<double> acting;               // S: sum of s |w| of the pairs that act, of each node
  std::vector<Vec3d> impulses;              // J of each pair; zero where it does not act [N·s]
  std::vector<bool> acts;                   // each pair, equation (1)
  std::vector<bool> beside_cloth;           // nodes on which pairs of different cloths act
  std::vector<RigidImpulse> body_impulses;  // of each collider; 0 where it is not rigid
  std::vector<RigidImpulse> body_pushes;    // likewise, pushes of its mass [kg m], [kg m²]
  std::vector<bool> struck;  // nodes with a pair with an obstacle that would end nearer than kStruckNear
};

/// v without its part along the unit vector n.
inline Vec3d part_across(const Vec3d& v, const Vec3d& n) { return v - dot(v, n) * n; }
/// v, cut to this length.
inline Vec3d no_longer(const Vec3d& v, double most) {
  const double size = length(v);
  return (size > most ? most / size : 1.0) * v;
}

/// u = Σ w v over both sides [m/s].
Vec3d relative_velocity(const NearPair& pair, std::span<const Vec3d> velocity);

/// The pairs' changes of the predicted velocities, and how far what is too near goes apart. In an iteration all pairs
/// are answered at once, from the same velocities; sums are taken in the order of the pairs. `bodies`: of each
/// collider; a rigid one takes part in its pairs as a vertex does, with its mass shared out among them.
Response respond(std::span<const NearPair> pairs, std::span<const Vec3d> velocity,
                 std::span<const double> inverse_mass, const ContactLaw& law,
                 std::span<const Movable> bodies = {});

}  // namespace weft::reference
