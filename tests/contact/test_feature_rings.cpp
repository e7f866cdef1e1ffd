// The rings of vertices, by a drawing.
#include <doctest/doctest.h>

#include "contact/proximity/feature_rings.hpp"
#include "state/contact_pairs.hpp"

using namespace weft;

TEST_CASE("rings name the two other corners of each triangle at a vertex, of cloth and then of colliders") {
  //  2---3
  //  | \ |     cloth; one triangle of a collider; its point 3 is a sphere's
  //  0---1
  const std::vector<mesh::Triangle> cloth{{0, 1, 2}, {1, 3, 2}}, colliders{{0, 1, 2}};
  const std::vector<std::uint32_t> words = contact::feature_rings(4, cloth, 4, colliders);
  const auto ring = [&](std::size_t row) {
    return std::vector<std::uint32_t>(words.begin() + words[row], words.begin() + words[row + 1]);
  };
  using Words = std::vector<std::uint32_t>;
  CHECK(words.size() == 9 + 2 * 9);
  CHECK(words[8] == words.size());
  CHECK(ring(0) == Words{1, 2});
  CHECK(ring(1) == Words{2, 0, 3, 2});
  CHECK(ring(2) == Words{0, 1, 1, 3});
  CHECK(ring(3) == Words{2, 1});
  CHECK(ring(4) == Words{kColliderPoint | 1, kColliderPoint | 2});
  CHECK(ring(6) == Words{kColliderPoint | 0, kColliderPoint | 1});
  CHECK(ring(7).empty());
}
