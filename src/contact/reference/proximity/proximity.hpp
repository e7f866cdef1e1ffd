// Contact method "proximity" for a substep, in double: finds near pairs, answers them, and lets nothing pass.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/reference/proximity/near_list.hpp"
#include "contact/reference/proximity/obstacles.hpp"
#include "contact/reference/proximity/press.hpp"
#include "contact/reference/proximity/respond.hpp"
#include "contact/reference/proximity/rigid.hpp"
#include "contact/reference/proximity/truncate.hpp"
#include "contact/reference/proximity/untangle.hpp"
#include "contact/rules/contact_law.hpp"
#include "contact/rules/solved_contact.hpp"
#include "contact/rules/yielding_edges.hpp"
#include "model/model.hpp"

namespace weft::reference {

class Proximity {
 public:
  /// `objects` and `deformations` as for Obstacles; `step`: the length of a substep, where frames are not cut [s];
  /// `solved`: what the method answers itself.
  Proximity(const scene::Scene& scene, const Model& model, std::span<const mesh::TriangleMesh> objects,
            std::span<const mesh::Deformation> deformations, double step, const SolvedContact& solved = {});

  /// The state of the nodes in a substep: the solver's prediction from `previous`, and moved nodes
  /// where their motions end. All finite.
  struct Nodes {
    std::span<const Vec3d> previous, velocity_before;  // [m], [m/s]
    std::span<const double> inverse_mass;              // [1/kg]
    std::span<Vec3d> position, velocity;               // [m], [m/s]
    std::vector<bool> held = {};                       // Stepper::held
    std::vector<Vec3d> pair_forces = {};               // Stepper::pair_forces
  };
  /// Changes position and velocity of vertices in contact in the substep from `begin`, of `dt` [s]. Returns how many
  /// pairs act.
  std::uint64_t answer(const Nodes& nodes, double begin, double dt);

  /// Nodes on which pairs of different cloths have acted in the last answer.
  const std::vector<bool>& beside_cloth() const { return beside_cloth_; }

  /// The effect of obstacles on nodes in the substep from `begin`, of `dt` [s], before it is solved.
  std::vector<Press> presses(std::span<const Vec3d> position, std::span<const Vec3d> velocity, double begin,
                             double dt);

  /// Whether cloth has met cloth in the last answer, in a blow, or was held back or limited.
  bool met() const { return met_; }

  /// Before the first substep of a frame of that length, and of so long ones [s].
  void begin_frame(double frame, double step) { most_delay_ = most_delay(frame, step); }

  /// Pairs of one cloth that come near in the substep of the last `presses`.
  std::vector<NearPair> pressed_pairs() const;

  /// Forgets the forces that pairs kept, and puts rigid bodies where they start.
  void forget() {
    kept_.clear();
    rigid_.reset();
  }
  RigidBodies& rigid() { return rigid_; }
  const RigidBodies& rigid() const { return rigid_; }

  const Obstacles& obstacles() const { return obstacles_; }
  double self_thickness() const { return self_thickness_; }  // h_s [m]; 0: cloth does not meet cloth
  /// In all substeps so far.
  const Truncated& truncated() const { return truncated_; }
  /// Edges that passed through triangles when it was last looked for them.
  std::size_t crossings() const { return tangle_.crossings; }

 private:
  /// One side of a pair: vertices of cloth or of obstacles, and their weights.
  struct Side {
    std::uint32_t count = 0;
    std::array<std::uint32_t, 3> vertices{};
    std::array<double, 3> weights{};
    bool obstacle = false;
  };
  struct Sides {
    Side a, b;
  };
  /// Where an obstacle's closest point is in the substep, and how far its feature comes.
  struct Surface {
    Vec3d velocity;      // of the material point [m/s]
    double support = 0;  // at the end: the most of m . x, where m points from the obstacle to cloth [m]
  };

  Sides sides_of(const FeaturePair& pair) const;
  Surface surface_of(const FeaturePair& pair, const Sides& sides, const Vec3d& toward_cloth, double dt) const;
  double friction_of(const FeaturePair& pair, const Sides& sides) const;
  SolvedContact solved_;
  /// Of a pair of cloth with itself [m].
  double thickness_of(const FeaturePair& pair, const Sides& sides) const;
  /// A pair and its force [N].
  struct Kept {
    FeaturePair pair;
    Vec3d force;
  };
  /// That of a pair in a sorted list; null: it has none.
  static const Kept* force_of(const std::vector<Kept>& sorted, const FeaturePair& pair);
  /// Sorted, of those that the solver's matrix has answered: `forces` are of pressed_pairs().
  std::vector<Kept> solved_pairs(std::span<const Vec3d> forces) const;
  NearPair near_pair(const FeaturePair& pair, const Sides& sides, bool untangles, double dt) const;
  /// Whether the solver's matrix has answered the pair: of a node that it holds, where it lay before the substep, so
  /// that it was among what pressed the node.
  bool is_held(const NearPair& pair, const std::vector<bool>& held) const;
  /// Of the sphere or capsule of a pair, if it has one.
  std::optional<RoundAxis> axis_of(const Sides& sides) const;
  /// Of the mesh of a pair, if it has one that keeps its shape; `surface`: that of its closest point.
  std::optional<CurvedSurface> curved_of(const FeaturePair& pair, const Sides& sides, const Vec3d& velocity,
                                         double dt) const;
  /// What a pair asks of truncate(): planes of a side that contact cannot move, or a pair of cloth. `expected`: where
  /// nodes end if contact does nothing [m].
  void add_limits(const FeaturePair& pair, const NearPair& near, bool acts, const Nodes& nodes,
                  std::span<const Vec3d> expected, double dt, std::vector<SolidPlane>& planes,
                  std::vector<ClothPair>& cloth) const;
  /// The direction, from B to A, across which the plane of a pair with an obstacle lies.
  Vec3d across(const FeaturePair& pair, double thickness, std::span<const Vec3d> expected) const;
  /// Near pairs for nodes that go up to `most` [m] and obstacles that go `obstacle_travel` [m].
  std::vector<FeaturePair> listed(double most, double travel, double obstacle_travel);
  /// Of a pair with a rigid body.
  std::optional<NearPair::Rigid> rigid_of(const FeaturePair& pair, const Sides& sides) const;
  /// Takes the obstacles to the substep's start and end. Returns how far the farthest of them goes [m].
  double move_obstacles(double begin, double dt);

  double thickness_, self_thickness_ = 0;
  double restitution_;
  Vec3d load_;
  ImpulseRule impulses_;
  PushTimes push_times_;
  std::uint32_t separations_;  // rounds
  std::vector<LimitedEdge> limited_edges_;
  std::vector<double> friction_;     // of each vertex's cloth
  std::vector<std::uint32_t> body_;  // of each vertex
  Features cloth_;                   // positions: at the start of the substep
  Features rest_;                    // the same at rest
  Obstacles obstacles_;
  RigidBodies rigid_;
  YieldingEdges yielding_;  // none beside rigid bodies, whose momentum would be lost
  Features object_;         // the obstacles at the start of the substep
  NearList list_;
  SurfaceFacts cloth_facts_, object_facts_;
  Tangle tangle_;
  std::uint64_t tangle_searched_ = 0;  // searches of `list_` when tangle_ was found
  Obstacles::Placed start_, end_;
  std::vector<Kept> kept_;  // of pairs that acted in the substep before; sorted
  struct Pressed {
    FeaturePair features;
    NearPair near;
  };
  std::vector<Pressed> pressed_;
  std::vector<bool> beside_cloth_;
  std::uint64_t most_delay_ = 0;  // of what is left of the frame [µs]
  bool met_ = false;
  Truncated truncated_;
};

}  // namespace weft::reference
