#include "contact/binary_tree.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace weft::contact {

double area(const Box& box) {
  const Vec3d size = box.high.to<double>() - box.low.to<double>();
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

namespace {

constexpr int kBins = 16;
constexpr std::uint32_t kMaxHeuristicDepth = 40;

struct Bin {
  Box box;
  std::uint32_t count = 0;

  void add(const Bin& other) {
    if (other.count == 0) return;
    box = count == 0 ? other.box : united(box, other.box);
    count += other.count;
  }
};

struct Plane {
  int axis = -1;  // -1: no plane parts the centres
  int bin = 0;    // bins below it go left
  double cost = std::numeric_limits<double>::infinity();
};

class Builder {
 public:
  explicit Builder(std::span<const ObjectTriangle> triangles) {
    tree_.order.resize(triangles.size());
    std::iota(tree_.order.begin(), tree_.order.end(), 0U);
    for (const ObjectTriangle& triangle : triangles) {
      boxes_.push_back(box_of(triangle));
      centers_.push_back(0.5 * (boxes_.back().low.to<double>() + boxes_.back().high.to<double>()));
    }
  }

  BinaryTree build() && {
    if (!boxes_.empty()) add_node(0, static_cast<std::uint32_t>(boxes_.size()), 0);
    return std::move(tree_);
  }

 private:
  std::uint32_t add_node(std::uint32_t begin, std::uint32_t end, std::uint32_t depth) {
    const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
    tree_.nodes.push_back({});
    Box box = boxes_[tree_.order[begin]];
    for (std::uint32_t i = begin; i < end; ++i) box = united(box, boxes_[tree_.order[i]]);
    tree_.nodes[index].box = box;
    if (end - begin <= kLeafTriangles) {
      std::sort(tree_.order.begin() + begin, tree_.order.begin() + end);
      tree_.nodes[index].first = begin;
      tree_.nodes[index].count = end - begin;
      return index;
    }
    const std::uint32_t middle = split(begin, end, depth);
    const std::uint32_t left = add_node(begin, middle, depth + 1);
    const std::uint32_t right = add_node(middle, end, depth + 1);
    tree_.nodes[index].left = left;
    tree_.nodes[index].right = right;
    return index;
  }

  std::uint32_t split(std::uint32_t begin, std::uint32_t end, std::uint32_t depth) {
    Vec3d low = centers_[tree_.order[begin]], high = low;
    for (std::uint32_t i = begin; i < end; ++i) {
      low = min(low, centers_[tree_.order[i]]);
      high = max(high, centers_[tree_.order[i]]);
    }
    const Plane plane = depth < kMaxHeuristicDepth ? cheapest_plane(begin, end, low, high) : Plane{};
    if (plane.axis < 0) return halve(begin, end, low, high);
    const auto middle =
        std::partition(tree_.order.begin() + begin, tree_.order.begin() + end, [&](std::uint32_t t) {
          return bin_of(centers_[t][plane.axis], low[plane.axis], high[plane.axis]) < plane.bin;
        });
    return static_cast<std::uint32_t>(middle - tree_.order.begin());
  }

  static int bin_of(double center, double low, double high) {
    return std::min(static_cast<int>(kBins * ((center - low) / (high - low))), kBins - 1);
  }

  Plane cheapest_plane(std::uint32_t begin, std::uint32_t end, const Vec3d& low, const Vec3d& high) const {
    Plane best;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(high[axis] > low[axis])) continue;
      std::array<Bin, kBins> bins;
      for (std::uint32_t i = begin; i < end; ++i) {
        const std::uint32_t t = tree_.order[i];
        bins[static_cast<std::size_t>(bin_of(centers_[t][axis], low[axis], high[axis]))].add({boxes_[t], 1});
      }
      std::array<double, kBins> right_cost{};  // of all bins from one on
      Bin right;
      for (std::size_t bin = kBins - 1; bin > 0; --bin) {
        right.add(bins[bin]);
        right_cost[bin] = right.count == 0 ? 0 : right.count * area(right.box);
      }
      Bin left;
      for (int bin = 1; bin < kBins; ++bin) {
        left.add(bins[static_cast<std::size_t>(bin - 1)]);
        if (left.count == 0 || left.count == end - begin) continue;
        const double cost = left.count * area(left.box) + right_cost[static_cast<std::size_t>(bin)];
        if (cost < best.cost) best = {axis, bin, cost};
      }
    }
    return best;
  }

  /// Halves by number along the longest side; equal centres are told apart by their numbers.
  std::uint32_t halve(std::uint32_t begin, std::uint32_t end, const Vec3d& low, const Vec3d& high) {
    const Vec3d size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::uint32_t i) { return tree_.order.begin() + i; };
    std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
      return centers_[a][axis] != centers_[b][axis] ? centers_[a][axis] < centers_[b][axis] : a < b;
    });
    return middle;
  }

  BinaryTree tree_;
  std::vector<Box> boxes_;
  std::vector<Vec3d> centers_;
};

}  // namespace

BinaryTree build_binary_tree(std::span<const ObjectTriangle> triangles) { return Builder(triangles).build(); }

}  // namespace weft::contact
