// How far cloth is sewn: which threads pull, and which nodes have become one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/result.hpp"
#include "model/model.hpp"

namespace weft {

struct Sewing {
  /// Of a pair: no thread pulls it yet; it is one node. Else it has a thread of the stiffness 2^this [N/m].
  static constexpr std::int32_t kLoose = -1000, kSewn = 1000, kMostExponent = 60;

  struct OfCloth {
    std::vector<std::int32_t> pairs;  // of all its seams, one after the other
    bool operator==(const OfCloth&) const = default;
  };
  std::vector<OfCloth> cloths;  // one for each body of the model; empty: nothing has begun
  double work = 0;  // what threads have been given to pull with, less what was taken from them [J]

  /// How many pairs are one node.
  std::size_t sewn() const;
  bool operator==(const Sewing&) const = default;
};

/// The model once it is sewn so far. Nodes that have become one have the number of the lowest and the mass of all; each
/// triangle stays as it is at rest by itself. Bodies' patterns say which node is which.
/// Reads   whole: as add_seams leaves it; of what has torn, as torn_model makes it.
/// Errors  Input: the sewing is not of this model.
Result<Model> sewn_model(const Model& whole, const Sewing& sewing);

/// Of each node of a model, those of the same model before that it is, sewn less far.
std::vector<std::vector<std::uint32_t>> sewn_from(const Model& model, const Model& then);

/// Whether any cloth of a scene is sewn.
bool is_sewn(const scene::Scene& scene);

/// Refuses a scene that is sewn, for a host that cannot follow it. Errors  Input.
Result<void> check_unsewn(const scene::Scene& scene);

}  // namespace weft
