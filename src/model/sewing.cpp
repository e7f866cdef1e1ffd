#include "model/sewing.hpp"

#include <algorithm>
#include <cmath>

#include "model/seams.hpp"

namespace weft {
namespace {

double thread_energy(std::int32_t exponent, double gap) {
  if (exponent == Sewing::kLoose || exponent == Sewing::kSewn) return 0;
  return std::ldexp(gap * gap, exponent) / 2;
}

/// The greatest power of two with which a thread pulls no harder than it may, where it is not nearly closed.
std::int32_t exponent_of(const CutSeam& seam, double gap) {
  const double wanted = std::floor(std::log2(seam.force / std::max(gap, seam.within / 2)));
  const double most = Sewing::kMostExponent;
  return static_cast<std::int32_t>(std::clamp(wanted, -most, most));
}

/// The pairs of one seam.
class SeamPairs {
 public:
  SeamPairs(const CutSeam& seam, const Body& body, std::span<const Vec3d> position,
            std::span<std::int32_t> pairs)
      : seam_(seam), pairs_(pairs) {
    for (const auto& [a, b] : seam.pairs) {
      const std::uint32_t first = body.pattern->node[a], second = body.pattern->node[b];
      gaps_.push_back(length(position[body.first_vertex + second] - position[body.first_vertex + first]));
      one_.push_back(first == second);
    }
  }

  bool open() const {
    return std::count(pairs_.begin(), pairs_.end(), Sewing::kSewn) != std::ptrdiff_t(pairs_.size());
  }

  void pull(bool waits) {
    const bool closed = *std::max_element(gaps_.begin(), gaps_.end()) <= seam_.within;
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      if (pairs_[k] == Sewing::kSewn) continue;
      const bool joins = one_[k] || closed || (!waits && gaps_[k] <= seam_.within);
      pairs_[k] = joins ? Sewing::kSewn : exponent_of(seam_, gaps_[k]);
    }
  }

  SeamNews news() const {
    SeamNews news{seam_.where};
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      if (pairs_[k] == Sewing::kSewn) continue;
      ++news.open;
      news.widest = std::max(news.widest, gaps_[k]);
    }
    return news;
  }

  double energy() const {
    double sum = 0;
    for (std::size_t k = 0; k < pairs_.size(); ++k) sum += thread_energy(pairs_[k], gaps_[k]);
    return sum;
  }

 private:
  const CutSeam& seam_;
  std::span<std::int32_t> pairs_;
  std::vector<double> gaps_;  // [m]
  std::vector<bool> one_;     // whether other seams have made one of a pair
};

void sew_cloth(const Body& body, std::span<const Vec3d> position, double time, double since,
               Sewing::OfCloth& cloth, Sewn& made) {
  std::size_t first = 0;
  for (const CutSeam& seam : body.pattern->seams) {
    const auto own = std::span(cloth.pairs).subspan(first, seam.pairs.size());
    first += seam.pairs.size();
    SeamPairs pairs(seam, body, position, own);
    if (time < seam.start || !pairs.open()) continue;
    const double before = pairs.energy();
    pairs.pull(time < seam.last);
    made.sewing.work += pairs.energy() - before;
    const bool gives_up = time >= seam.last && time - since < seam.last;
    if (!pairs.open() || gives_up) made.news.push_back(pairs.news());
  }
}

}  // namespace

Sewn sew(const Model& model, const Sewing& before, std::span<const Vec3d> position, double time,
         double since) {
  Sewn made;
  made.sewing = before;
  made.sewing.cloths.resize(model.bodies.size());
  for (std::size_t c = 0; c < model.bodies.size(); ++c) {
    const Body& body = model.bodies[c];
    if (!body.pattern) continue;
    made.sewing.cloths[c].pairs.resize(pair_count(*body.pattern), Sewing::kLoose);
    sew_cloth(body, position, time, since, made.sewing.cloths[c], made);
  }
  return made;
}

}  // namespace weft
