// What a search and the first substep behind it leave of records, against the law.
#pragma once

#include "contact/search_checks.hpp"

namespace weft {

/// Which pairs the law of docs/contact.md gives a record where nothing moves: crossings, cloth with a side that contact
/// cannot move, between tangled sides, and nearer than they keep. `band` [m]: where rounding decides, either is right.
class NeedsRecord {
 public:
  enum class Need : std::uint8_t { No, Either, Yes };
  NeedsRecord(const SearchFound& found, const SearchRun& run, double band)
      : found_(found), run_(run), band_(band) {
    using reference::PairKind;
    for (const PossiblePair& pair : possible_pairs(found, run, band)) {
      // What a round obstacle spares (spare_of) is that part of the thickness at most.
      const PairKind kind = pair.moving.kind;
      const bool may_spare = pair.moving.radius > 0 &&
                             (kind == PairKind::ObjectVertexTriangle || kind == PairKind::EdgeObjectEdge);
      gaps_[pair.key] = {gap_at(pair.moving, start_of(pair.moving)).distance,
                         pair.doubt + (may_spare ? kMostSpare * pair.thickness : 0)};
    }
  }

  Need operator()(const ListedPair& pair) const {
    if (is_crossing(pair)) return Need::Yes;
    if (((pair.ids[0] | pair.ids[1] | pair.ids[2]) & kColliderPoint) != 0) return near_collider(pair);
    if (thickness_of(pair) == 0) return Need::No;
    const bool edges = (pair.ids[0] & kPairFlag) != 0;
    const std::size_t of_a = edges ? 2 : 1;
    if (held(pair, 0, of_a) || held(pair, of_a, 4)) return Need::Yes;
    if (tangled(pair, 0, of_a) && tangled(pair, of_a, 4)) return Need::Yes;
    std::array<Vec3d, 4> at;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!finite(place(pair, k))) return Need::Either;
      at[k] = place(pair, k).to<double>();
    }
    const double distance = edges ? reference::closest_segments(at[0], at[1], at[2], at[3]).distance
                                  : reference::closest_on_triangle(at[0], at[1], at[2], at[3]).distance;
    return nearer(distance - 1.001 * static_cast<double>(thickness_of(pair)), band_);
  }

 private:
  static Need nearer(double beyond, double band) {
    if (!(std::abs(beyond) > band)) return Need::Either;
    return beyond < 0 ? Need::Yes : Need::No;
  }
  Need near_collider(const ListedPair& pair) const {
    constexpr std::uint32_t kByMesh = 2;
    const auto gap = gaps_.find(key_of(pair.ids));
    if (gap == gaps_.end()) return Need::Either;  // a place that is no number
    const bool plane = (pair.ids[1] & kPairFlag) != 0;
    for (std::size_t k = 0; !plane && k < 4; ++k)
      if ((pair.ids[k] & kColliderPoint) == 0 &&
          (found_.vertex_contacts[kVertexWords * vertex(pair, k) + kTangledWord] & kByMesh) != 0)
        return Need::Yes;
    const auto& [distance, doubt] = gap->second;
    return nearer(distance - 1.001 * static_cast<double>(run_.setup().thickness), doubt);
  }
  std::uint32_t vertex(const ListedPair& pair, std::size_t k) const { return pair.ids[k] & kIdBits; }
  const Vec3f& place(const ListedPair& pair, std::size_t k) const {
    return run_.setup().cloth.positions[vertex(pair, k)];
  }
  bool held(const ListedPair& pair, std::size_t first, std::size_t end) const {
    const std::vector<bool>& all = run_.setup().held;
    for (std::size_t k = first; k < end; ++k)
      if (vertex(pair, k) >= all.size() || !all[vertex(pair, k)]) return false;
    return true;
  }
  bool tangled(const ListedPair& pair, std::size_t first, std::size_t end) const {
    constexpr std::uint32_t kByCloth = 1;
    for (std::size_t k = first; k < end; ++k)
      if ((found_.vertex_contacts[kVertexWords * vertex(pair, k) + kTangledWord] & kByCloth) != 0)
        return true;
    return false;
  }

  const SearchFound& found_;
  const SearchRun& run_;
  double band_;
  std::map<FeatureKey, std::array<double, 2>> gaps_;  // and how far f32 may have them otherwise [m]
};

/// The pairs that need one have a record, each its own; the links of each cloth vertex lead to all its records,
/// once to each.
inline void check_records(const SearchFound& found, const SearchRun& run, double band) {
  const NeedsRecord needs(found, run, band);
  std::vector<bool> seen(found.records.size());
  std::size_t wrong = 0, roles = 0, recorded = 0;
  for (std::size_t p = 0; p < found.pairs.size(); ++p) {
    const bool has = (found.after[p].words[0] & kHasRecord) != 0;
    const NeedsRecord::Need need = needs(found.pairs[p]);
    if (need != NeedsRecord::Need::Either && has != (need == NeedsRecord::Need::Yes)) ++wrong;
    if (!has) continue;
    ++recorded;
    const std::uint32_t number = found.after[p].words[0] & ~kHasRecord;
    REQUIRE(number < found.records.size());
    if (seen[number] || found.records[number].ids != found.pairs[p].ids) ++wrong;
    seen[number] = true;
    const std::size_t count = (found.pairs[p].ids[1] & kPairFlag) != 0 ? 2 : 4;
    for (std::size_t role = 0; role < count; ++role)
      roles += (found.pairs[p].ids[role] & kColliderPoint) == 0 ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(recorded == found.records.size());
  std::size_t linked = 0;
  for (std::uint32_t v = 0; v < run.setup().cloth.positions.size(); ++v) {
    std::uint32_t link = found.vertex_contacts[kVertexWords * v];
    for (; link != 0 && linked <= roles; ++linked) {
      const std::uint32_t number = link / 4 - 1, role = link % 4;
      REQUIRE(number < found.records.size());
      if ((found.records[number].ids[role] & (kIdBits | kColliderPoint)) != v) ++wrong;
      link = found.records[number].next[role];
    }
  }
  CHECK(wrong == 0);
  CHECK(linked == roles);
}

/// Broad phase, narrow phase and records of the case as it stands.
inline ListCheck check_all(SearchRun& run, double band = 0) {
  const SearchFound found = run.run();
  const NamedCandidates names = named(found, run);
  check_self_candidates(found, names, run);
  for (std::size_t o = 0; o < run.setup().objects.size(); ++o) check_object_candidates(found, names, run, o);
  const double rounding = band > 0 ? band : 1e-5 * run.setup().self_radius();
  const ListCheck checked = check_pairs(found, run, rounding);
  check_records(found, run, rounding);
  return checked;
}

}  // namespace weft
