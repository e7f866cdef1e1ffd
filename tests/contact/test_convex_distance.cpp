// The distance of triangles and convex bodies in double: GJK against brute force over all features.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "contact/convex_pairs.hpp"
#include "contact/reference/pushes/gjk.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

/// In units of 2^-53 of the pair's size (pair_size). GJK's distance is that of two points, one of each body, so it is
/// too short by rounding only: a simplex has differences of places (1 a coordinate), its nearest point is a sum of
/// three products with weights that are rounded themselves (8), along a diagonal below 1.8 (1 + 8) = 16. It is too long
/// by no more than its distance from the lower bound, the support along a direction, which is asked to be below 48
/// (else brute force tells), and by the rounding of that (3 products, 2 sums: below 9, in the reserve, as the distance
/// is then not too short). Brute force rounds less. Of pairs that overlap both take the direction of a face or of two
/// edges, a cross product with a relative error of 6: a way along it is wrong by 12 with the dot product.
constexpr double kBound = 64 * 0x1p-53;

struct Tally {
  std::size_t pairs = 0, overlapping = 0, wrong = 0, loose = 0;
  double worst = 0;  // in units of 2^-53 of the size
  std::uint64_t iterations = 0;
  std::uint32_t most = 0;
  std::size_t by_features = 0;
};

void check(const CornersOfTriangle& corners, const ConvexBody& body, Tally& tally) {
  const TrianglePoints triangle = points_of(corners);
  const GjkContact found = contact_by_gjk(triangle, body);
  const ConvexContact exact = contact_by_features(triangle, body);
  const double size = pair_size(triangle, body);
  const double error = std::abs(found.contact.distance - exact.distance);
  ++tally.pairs;
  tally.overlapping += exact.distance < 0 ? 1 : 0;
  tally.wrong += error <= kBound * size ? 0 : 1;
  tally.worst = std::max(tally.worst, error / (size * 0x1p-53));
  tally.iterations += found.iterations;
  tally.most = std::max(tally.most, found.iterations);
  tally.by_features += found.by_features ? 1 : 0;
  // The points are as far apart as is said, along the direction that is said. Of a pair that only touches the direction
  // is one that separates it, and its points are as near to each other as those that touch (kTouch of gjk.cpp,
  // 2^-24.5).
  const auto& w = found.contact.weights;
  const Vec3d p = w[0] * triangle.a + w[1] * triangle.b + w[2] * triangle.c;
  const Vec3d off = p - found.contact.point - found.contact.distance * found.contact.normal;
  const bool sums = std::abs(w[0] + w[1] + w[2] - 1) < 1e-14 && std::min({w[0], w[1], w[2]}) >= 0;
  const bool unit = std::abs(length(found.contact.normal) - 1) < 1e-14;
  tally.loose += sums && unit && length(off) <= 0x1p-22 * size ? 0 : 1;
}

void run(std::size_t each, std::size_t most_points, std::size_t pairs) {
  const std::vector<mesh::TriangleMesh> meshes = convex_bodies(each, most_points);
  std::vector<ConvexBody> bodies(meshes.begin(), meshes.end());
  Random random(4);
  for (int sort = 0; sort < kTriangleSorts; ++sort) {
    Tally tally;
    for (std::size_t k = 0; k < pairs / kTriangleSorts; ++k) {
      const std::size_t body = k % meshes.size();
      check(random_triangle(random, meshes[body], static_cast<TriangleSort>(sort)), bodies[body], tally);
    }
    CAPTURE(sort);
    CHECK(tally.wrong == 0);
    CHECK(tally.loose == 0);
    CHECK(tally.most < 64);  // so no search was given up
    CHECK(tally.by_features <= tally.pairs / 10);
    MESSAGE(sort << ": " << tally.pairs << " pairs, " << tally.overlapping << " overlap, error "
                 << tally.worst << ", iterations "
                 << static_cast<double>(tally.iterations) / static_cast<double>(tally.pairs) << " (most "
                 << tally.most << "), by features " << tally.by_features);
  }
}

}  // namespace

TEST_CASE("GJK in double has the distance that brute force over features has") { run(2, 40, 22000); }

TEST_CASE("long: GJK in double has it for a million pairs") { run(6, 40, 1100000); }

TEST_CASE("GJK in double has it for hulls of up to 500 points") { run(1, 500, 770); }
