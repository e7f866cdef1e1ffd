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

/// What is grabbed in a frame. Kept from frame to frame, so that none allocates.
struct FrameGrabs {
  std::vector<std::uint32_t> nodes;   // those of the hand, then those of the scene
  std::vector<Vec4f> still;           // where the hand pulls [m]
  std::vector<Vec4f> moving;          // where the scene pulls, substep after substep [m]
  std::vector<std::size_t> scripted;  // the scene's grabs that act in the frame
  std::vector<std::size_t> slots;     // of each of them, among the nodes of the scene
};

/// The most nodes that the scene's grabs hold in a frame of so many seconds, whenever it begins.
std::size_t most_scripted(const Model& model, double frame);

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
  /// The nodes that may be grabbed between two times [s]: those of the host's hand, then those of the scene.
  void find(double from, double to, FrameGrabs& found) const;
  /// Appends where the scene pulls its nodes of `found` in the substep that ends at `time` [s]; w: 1, or 0 where it
  /// does not.
  void append_goals(FrameGrabs& found, double time) const;
  /// Fills the part of a substep of length `dt` [s], but for what GrabSlots fills.
  void fill(StepBlock::Hands& hands, double dt) const;

 private:
  Result<Grabbed*> find(std::uint32_t node);
  Result<void> check(std::uint32_t node, double time) const;
  /// Whether the scene does not grab this node at `time` or later, and leaves room for `others` beside it.
  Result<void> check_scene(std::uint32_t node, std::size_t others, double time) const;
  /// The most nodes that the scene grabs at once after `time`.
  std::size_t needed_by_scene(double time) const;

  std::vector<std::uint32_t> motion_;  // Model::motion
  std::vector<NodeGrab> scripted_;     // by their nodes
  std::vector<Grabbed> grabbed_;
  double speed_ = 0;  // [m/s]
};

}  // namespace weft::sim
