// What has torn: which nodes have parted, and how the triangles are joined since.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/result.hpp"
#include "model/model.hpp"

namespace weft {

/// Triangles keep their number and their order; nodes that are added come behind the cloth's own.
struct Tears {
  struct OfCloth {
    std::vector<std::uint32_t>
        origin;  // of each node that was added, the whole cloth's node that it is a part of
    std::vector<mesh::Triangle> triangles;  // nodes count from the cloth's first; empty: it is whole
    bool operator==(const OfCloth&) const = default;
  };
  std::vector<OfCloth> cloths;  // one for each body of the model; empty: all are whole

  /// How often a node has parted.
  std::size_t splits() const;
  bool operator==(const Tears&) const = default;
};

/// The model once it has torn so. The parts of a node share its mass by the area of their triangles at rest, and have
/// its place at rest, its motion or pin; the one that keeps its number keeps its grab.
/// Reads   whole: as build_model makes it.
/// Errors  Input: the tears are not of this model.
Result<Model> torn_model(const Model& whole, const Tears& tears);

/// Refuses a scene that tears, for a host that cannot follow it. Errors  Input.
Result<void> check_whole(const scene::Scene& scene);

/// Whether any cloth of a scene can tear.
bool can_tear(const scene::Scene& scene);

}  // namespace weft
