// The grabbed nodes: by the scene's own grabs, and by the host's hand.
#pragma once

#include <vector>

#include "model/model.hpp"
#include "state/step_block.hpp"

namespace weft::sim {

/// A node that the host's hand has grabbed.
struct Grabbed {
  std::uint32_t node = 0;
  Vec3d target;  // [m]
};

/// At most scene::kMaxGrabs nodes are grabbed at any time. Those that the scene will need are kept free.
class Grabs {
 public:
  explicit Grabs(const Model& model);

  /// Grabs a free node from now on. Errors  Input: no such node; it is pinned, moved, or grabbed now or later by
  /// the scene; a target that is not finite. Limit: as many are grabbed as can be.
  Result<void> grab(std::uint32_t node, const Vec3d& target, double time);
  /// Pulls a grabbed node to another place. Errors  Input: it is not grabbed; a target that is not finite.
  Result<void> drag(std::uint32_t node, const Vec3d& target);
  /// Lets a node go. Errors  Input: it is not grabbed.
  Result<void> release(std::uint32_t node);
  /// Whether what is grabbed could be grabbed at `time` [s] too. Errors  Input: the scene grabs such a node then or
  /// later. Limit: too many are.
  Result<void> check_at(double time) const;
  /// Lets all go but those that the scene grabs.
  void release_all() { grabbed_.clear(); }
  /// What the host's hand has grabbed.
  const std::vector<Grabbed>& held() const { return grabbed_; }

  /// Whether a node may be grabbed between two times [s].
  bool any(double from, double to) const;
  /// Fills the part of a substep of length `dt` [s] that ends at `time` [s].
  void fill(StepBlock::Hands& hands, double dt, double time) const;

 private:
  Result<Grabbed*> find(std::uint32_t node);
  Result<void> check(std::uint32_t node, double time) const;
  /// Whether the scene does not grab this node at `time` or later, and leaves room for `others` beside it.
  Result<void> check_scene(std::uint32_t node, std::size_t others, double time) const;
  /// The most nodes that the scene grabs at once after `time`.
  std::size_t needed_by_scene(double time) const;

  std::vector<std::uint32_t> motion_;  // Model::motion
  std::vector<NodeGrab> scripted_;
  std::vector<Grabbed> grabbed_;
  double speed_ = 0;  // [m/s]
};

}  // namespace weft::sim
