// How the nodes of a glTF scene move.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/glb_chunks.hpp"
#include "mesh/gltf_nodes.hpp"

namespace weft::mesh {

/// One part of a node's transform over time.
struct GltfChannel {
  enum class Path { Translation, Rotation, Scale };
  enum class Interpolation { Linear, Step, CubicSpline };

  std::size_t node = 0;  // its place among the scene's nodes
  Path path = Path::Translation;
  Interpolation interpolation = Interpolation::Linear;
  std::vector<double> times;  // rising [s]
  std::vector<double>
      values;  // of each time 3 or 4; of a spline three times as many: slope in, value, slope out

  /// Before the first time and after the last the values are theirs. Rotations are unit quaternions.
  std::vector<double> at(double time) const;
};

struct GltfAnimation {
  std::string name;     // "" where the file gives none
  double duration = 0;  // up to the last time of all channels [s]
  std::vector<GltfChannel> channels;

  /// Parts of the scene's nodes at a time: those that it moves are put in place of `parts`.
  void move(double time, std::vector<NodeParts>& parts) const;
};

/// The animations of a file, for these nodes of its scene; weights of morph targets, and nodes that are in no tree of
/// the scene, are passed over.
/// Errors  Input: what is wrong, with its path; more numbers than `limit` bytes hold.
Result<std::vector<GltfAnimation>> gltf_animations(const GlbChunks& glb, const std::vector<SceneNode>& nodes,
                                                   std::uint64_t limit);

}  // namespace weft::mesh
