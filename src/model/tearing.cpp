#include "model/tearing.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "mesh/adjacency.hpp"
#include "mesh/sides.hpp"
#include "model/tension.hpp"

namespace weft {
namespace {

/// A neighbour of a node, and the triangles of the edge to it.
struct Spoke {
  std::uint32_t node = 0;
  std::vector<std::uint32_t> triangles;
};

/// One cloth while nodes of it part. All nodes count from the cloth's first.
class TornCloth {
 public:
  TornCloth(const Model& model, const Body& body, Tears::OfCloth tears, std::span<const Vec3d> position)
      : whole_nodes_(body.vertex_count - static_cast<std::uint32_t>(tears.origin.size())),
        tears_(std::move(tears)) {
    tears_.triangles = own_triangles(model, body);
    for (std::uint32_t node = 0; node < body.vertex_count; ++node) {
      from_.push_back(node);
      position_.push_back(position[body.first_vertex + node]);
    }
    const mesh::Adjacency rows = mesh::triangle_adjacency(body.vertex_count, tears_.triangles);
    for (std::uint32_t node = 0; node < body.vertex_count; ++node)
      at_.emplace_back(rows.row(node).begin(), rows.row(node).end());
  }

  /// Parts a node across a direction. False where its triangles are no single fan, or one of one triangle.
  bool split(std::uint32_t node, const Vec3d& pull) {
    const std::vector<Spoke> spokes = spokes_of(node);
    Vec3d normal;
    for (const std::uint32_t t : at_[node]) normal += normal_of(t);
    const Vec3d crack = cross(pull, normal);
    std::vector<std::pair<double, std::uint32_t>> along;  // of the edges of two triangles, by the crack
    for (const Spoke& spoke : spokes) {
      if (spoke.triangles.size() > 2) return false;
      const Vec3d way = position_[spoke.node] - position_[node];
      if (spoke.triangles.size() == 2) along.emplace_back(dot(way, crack) / length(way), spoke.node);
    }
    const bool closed = along.size() == at_[node].size();
    if (along.size() < (closed ? 2 : 1) || parts_of(node, {}).size() != 1) return false;
    const auto [least, most] = std::minmax_element(along.begin(), along.end());
    std::vector<std::uint32_t> cut;
    if (closed)
      cut = {least->second, most->second};
    else
      cut = {-least->first > most->first ? least->second : most->second};
    part(node, parts_of(node, cut));
    for (const std::uint32_t end : cut) part(end, parts_of(end, {}));  // a crack that has come to the rim
    return true;
  }

  /// Those that share a triangle with a node.
  std::vector<std::uint32_t> ring(std::uint32_t node) const {
    std::vector<std::uint32_t> nodes;
    for (const std::uint32_t t : at_[node])
      nodes.insert(nodes.end(), tears_.triangles[t].begin(), tears_.triangles[t].end());
    return nodes;
  }
  const std::vector<std::uint32_t>& from() const { return from_; }
  Tears::OfCloth take() { return std::move(tears_); }

 private:
  Vec3d normal_of(std::uint32_t triangle) const {
    const mesh::Triangle& t = tears_.triangles[triangle];
    return cross(position_[t[1]] - position_[t[0]], position_[t[2]] - position_[t[0]]);
  }

  std::vector<Spoke> spokes_of(std::uint32_t node) const {
    std::vector<Spoke> spokes;
    for (const std::uint32_t t : at_[node])
      for (const std::uint32_t other : tears_.triangles[t]) {
        if (other == node) continue;
        const auto found = std::find_if(spokes.begin(), spokes.end(),
                                        [&](const Spoke& spoke) { return spoke.node == other; });
        if (found == spokes.end())
          spokes.push_back({other, {t}});
        else
          found->triangles.push_back(t);
      }
    return spokes;
  }

  /// A node's triangles, by what hangs together over edges that are not cut; the lowest number first.
  std::vector<std::vector<std::uint32_t>> parts_of(std::uint32_t node,
                                                   const std::vector<std::uint32_t>& cut) const {
    const std::vector<std::uint32_t>& own = at_[node];
    const auto place = [&](std::uint32_t t) {
      return static_cast<std::size_t>(std::find(own.begin(), own.end(), t) - own.begin());
    };
    std::vector<std::size_t> part(own.size());
    std::iota(part.begin(), part.end(), 0U);
    for (const Spoke& spoke : spokes_of(node)) {
      if (std::find(cut.begin(), cut.end(), spoke.node) != cut.end()) continue;
      for (const std::uint32_t t : spoke.triangles) {
        const std::size_t a = part[place(t)], b = part[place(spoke.triangles[0])];
        for (std::size_t& one : part)
          if (one == std::max(a, b)) one = std::min(a, b);
      }
    }
    std::vector<std::vector<std::uint32_t>> parts;
    for (std::size_t number = 0; number < own.size(); ++number) {
      std::vector<std::uint32_t> members;
      for (std::size_t k = 0; k < own.size(); ++k)
        if (part[k] == number) members.push_back(own[k]);
      if (!members.empty()) parts.push_back(std::move(members));
    }
    return parts;
  }

  /// The first part keeps the node; each other one gets a node of its own.
  void part(std::uint32_t node, const std::vector<std::vector<std::uint32_t>>& parts) {
    at_[node] = parts[0];
    for (std::size_t k = 1; k < parts.size(); ++k) {
      const auto added = static_cast<std::uint32_t>(from_.size());
      tears_.origin.push_back(node < whole_nodes_ ? node : tears_.origin[node - whole_nodes_]);
      from_.push_back(from_[node]);
      position_.push_back(position_[node]);
      at_.push_back(parts[k]);
      for (const std::uint32_t t : parts[k])
        std::replace(tears_.triangles[t].begin(), tears_.triangles[t].end(), node, added);
    }
  }

  std::uint32_t whole_nodes_ = 0;
  Tears::OfCloth tears_;
  std::vector<std::uint32_t> from_;
  std::vector<Vec3d> position_;                 // [m]
  std::vector<std::vector<std::uint32_t>> at_;  // of each node its triangles
};

struct Candidate {
  Principal tension;  // [N/m]
  std::uint32_t node = 0;
};

/// The nodes that may part, those that bear most first.
std::vector<Candidate> candidates(const Model& model, const Body& body, std::span<const Vec3d> position) {
  std::vector<Candidate> found;
  const std::vector<Mat3> all = tensions(model, body, position);
  for (std::uint32_t node = 0; node < body.vertex_count; ++node) {
    if (model.kinematic(body.first_vertex + node)) continue;
    const Principal tension = largest_principal(all[node]);
    if (tension.value > *body.strength) found.push_back({tension, node});
  }
  std::sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    return std::tuple(-a.tension.value, a.node) < std::tuple(-b.tension.value, b.node);
  });
  return found;
}

/// Of each node whether a tear has come to it: an edge of it had two triangles that share it no more.
std::vector<bool> at_tears(const Model& model, const Body& body) {
  std::vector<bool> torn(body.vertex_count);
  const std::vector<mesh::Triangle> triangles = own_triangles(model, body);
  const std::vector<mesh::Side> sides = mesh::sorted_sides(body.whole);
  mesh::for_each_edge(sides, [&](std::span<const mesh::Side> of_edge) {
    const auto ends = [&](const mesh::Side& side) {
      const mesh::Triangle& t = triangles[side.triangle];
      return std::minmax({t[side.start()], t[(side.start() + 1) % 3]});
    };
    for (const mesh::Side& side : of_edge) {
      if (ends(side) == ends(of_edge[0])) continue;
      for (const mesh::Side& parted : {side, of_edge[0]}) {
        torn[ends(parted).first] = true;
        torn[ends(parted).second] = true;
      }
    }
  });
  return torn;
}

}  // namespace

std::optional<Tearing> tear(const Model& model, const Tears& tears, std::span<const Vec3d> position) {
  Tearing made;
  for (std::size_t c = 0; c < model.bodies.size(); ++c) {
    const Body& body = model.bodies[c];
    Tears::OfCloth before = tears.cloths.empty() ? Tears::OfCloth{} : tears.cloths[c];
    const std::vector<Candidate> found =
        body.strength ? candidates(model, body, position) : std::vector<Candidate>();
    if (found.empty()) {
      for (std::uint32_t node = 0; node < body.vertex_count; ++node)
        made.from.push_back(body.first_vertex + node);
      made.tears.cloths.push_back(std::move(before));
      continue;
    }
    TornCloth cloth(model, body, before, position);
    std::vector<bool> beside(body.vertex_count);  // what a split changes the tension of
    const std::vector<bool> torn = at_tears(model, body);
    std::size_t splits = 0, begun = 0;
    for (const Candidate& candidate : found) {
      if (splits == kMostSplits) break;
      if (beside[candidate.node] || (!torn[candidate.node] && begun == kMostNewTears)) continue;
      const std::vector<std::uint32_t> ring = cloth.ring(candidate.node);
      if (!cloth.split(candidate.node, candidate.tension.direction)) continue;
      ++splits;
      if (!torn[candidate.node]) ++begun;
      for (const std::uint32_t node : ring)
        if (node < beside.size()) beside[node] = true;
    }
    for (const std::uint32_t node : cloth.from()) made.from.push_back(body.first_vertex + node);
    made.tears.cloths.push_back(splits > 0 ? cloth.take() : std::move(before));
  }
  if (made.tears.splits() == tears.splits()) return std::nullopt;
  return made;
}

}  // namespace weft
