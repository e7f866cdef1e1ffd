// The nodes that are held: by the scene's own grabs, and by who works with the world.
#pragma once

#include <vector>

#include "model/host_model.hpp"
#include "state/step_block.hpp"

namespace weft::sim {

/// At most scene::kMaxGrabs nodes are held at any time. Those that the scene will need are kept free.
class Grabs {
 public:
  explicit Grabs(const HostModel& model);

  /// Holds a free node from now on. Errors  Input: no such node; it is pinned, moved, or held now or later by
  /// the scene; a target that is not finite. Limit: as many are held as can be.
  Result<void> grab(std::uint32_t node, const Vec3d& target, double time);
  /// Pulls a held node to another place. Errors  Input: it is not held; a target that is not finite.
  Result<void> drag(std::uint32_t node, const Vec3d& target);
  /// Lets a node go. Errors  Input: it is not held.
  Result<void> release(std::uint32_t node);
  /// Lets all go but those that the scene holds.
  void release_all() { held_.clear(); }

  /// Whether a node may be held between two times [s].
  bool any(double from, double to) const;
  /// Fills the part of a substep of length `dt` [s] that ends at `time` [s].
  void fill(StepBlock::Hands& hands, double dt, double time) const;

 private:
  struct Held {
    std::uint32_t node = 0;
    Vec3d target;  // [m]
  };

  Result<Held*> find(std::uint32_t node);
  Result<void> check(std::uint32_t node, double time) const;
  /// The most nodes that the scene holds at once after `time`.
  std::size_t needed_by_scene(double time) const;

  std::vector<std::uint32_t> motion_;  // HostModel::motion
  std::vector<NodeGrab> scripted_;
  std::vector<Held> held_;
  double speed_ = 0;  // [m/s]
};

}  // namespace weft::sim
