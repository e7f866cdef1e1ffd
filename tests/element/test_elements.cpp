// Tables of elements, who meets at a node, and colours.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "base/random.hpp"
#include "element/colors.hpp"
#include "element/incidence.hpp"
#include "element/spring/build.hpp"
#include "element/spring/law.hpp"
#include "element/triple/triple.hpp"

using namespace weft;

namespace {

ElementTable random_elements(ElementKind kind, std::uint32_t nodes, std::uint32_t count, std::uint64_t seed) {
  Random random(seed);
  ElementTable table{kind, {}, {}, {}};
  for (std::uint32_t e = 0; e < count; ++e) {
    std::set<std::uint32_t> own;
    while (own.size() < table.arity()) own.insert(random.below(nodes));
    table.nodes.insert(table.nodes.end(), own.begin(), own.end());
  }
  return table;
}

std::size_t most_at_a_node(const mesh::Adjacency& rows) {
  std::size_t most = 0;
  for (std::size_t node = 0; node < rows.row_count(); ++node) most = std::max(most, rows.row(node).size());
  return most;
}

}  // namespace

TEST_CASE("every element is in the rows of its nodes, and rows ascend, whatever the kind") {
  for (const ElementKind kind :
       {ElementKind::Spring, ElementKind::Triple, ElementKind::Hinge, ElementKind::Tet}) {
    ElementTable table = random_elements(kind, 40, 300, 5);
    for (std::uint32_t& node : table.nodes) node += 7;  // those of other bodies come before
    const mesh::Adjacency rows = incidence(table, 7, 41);
    REQUIRE(rows.row_count() == 41);
    CHECK(rows.entries.size() == table.nodes.size());
    CHECK(rows.row(40).empty());
    for (std::uint32_t node = 0; node < 40; ++node) {
      CHECK(std::is_sorted(rows.row(node).begin(), rows.row(node).end()));
      for (const std::uint32_t element : rows.row(node)) {
        const auto nodes = table.nodes_of(element);
        CHECK(std::count(nodes.begin(), nodes.end(), node + 7) == 1);
      }
    }
  }
}

TEST_CASE("no two elements of a colour share a node, every element has one, and greedy needs few") {
  for (const ElementKind kind : {ElementKind::Spring, ElementKind::Triple, ElementKind::Tet})
    for (const auto& [nodes, count] :
         {std::pair{5U, 1U}, {40U, 300U}, {6U, 600U}}) {  // the last: above 64 colours
      const ElementTable table = random_elements(kind, nodes, count, nodes);
      const Colors colors = color_elements(table, nodes);
      std::set<std::uint32_t> seen;
      for (std::uint32_t c = 0; c < colors.count(); ++c) {
        CHECK(!colors.of(c).empty());
        CHECK(std::is_sorted(colors.of(c).begin(), colors.of(c).end()));
        std::set<std::uint32_t> touched;
        for (const std::uint32_t element : colors.of(c)) {
          CHECK(seen.insert(element).second);
          for (const std::uint32_t node : table.nodes_of(element)) CHECK(touched.insert(node).second);
        }
      }
      CHECK(seen.size() == count);
      const std::size_t most = most_at_a_node(incidence(table, 0, nodes));
      CHECK(colors.count() >= most);
      CHECK(colors.count() <= 1 + table.arity() * (most - 1));
      CHECK(color_elements(table, nodes).elements == colors.elements);
    }
  CHECK(color_elements({ElementKind::Spring, {}, {}, {}}, 3).count() == 0);
}

TEST_CASE(
    "a node inside a grid has twelve springs and six triples, and the colours of its springs are a few "
    "more") {
  const mesh::Grid grid{12, 9, 1.1, 0.8};
  const ElementTable springs = build_springs(grid, {{300, 200, 100, 0}, 0.5, mesh::BoundaryWeights::Area}, 0);
  CHECK(springs.size() == mesh::grid_spring_count(grid));
  CHECK(incidence(springs, 0, 108).row(mesh::node_index(grid, 5, 4)).size() == 12);
  CHECK(incidence(springs, 0, 108).row(0).size() == 5);  // two, one and two, at a corner
  const Colors colors = color_elements(springs, 108);
  CHECK(colors.count() >= 12);
  CHECK(colors.count() <= 23);  // greedy: 1 + 2 * 11
  const ElementTable triples = build_triples(grid, 1e-3, mesh::BoundaryWeights::Area, 0);
  CHECK(triples.size() == 10 * 9 + 12 * 7);
  CHECK(incidence(triples, 0, 108).row(mesh::node_index(grid, 5, 4)).size() == 6);
  CHECK(build_triples(grid, 0, mesh::BoundaryWeights::Area, 0).size() == 0);
}

TEST_CASE(
    "the force of a spring is the slope of its energy, its block that of its force where it is stretched") {
  Random random(3);
  for (int sample = 0; sample < 50; ++sample) {
    const auto draw = [&] {
      return Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    };
    const Vec3d span = draw(), way = draw();
    const double rest = random.uniform(0.1, 1) * length(span), k = random.uniform(1, 100), h = 1e-5;
    // Without a limit, below one, and beyond one.
    const double longest = sample % 3 == 0 ? 0 : (sample % 3 == 1 ? 1.01 : 0.99) * length(span);
    const spring::Law law = spring::Law::of(rest, k, std::max(longest, longest > 0 ? rest : 0));
    const double stiffest = law.stiffness + law.more;
    const spring::Pull pull = spring::pull(span, {}, law, 0.3);
    // Central differences are within h² k |way|³ / rest² of it; the roundings of energies below 2 kJ are 2e-13 / h.
    const double slope =
        (spring::energy(span + h * way, law) - spring::energy(span - h * way, law)) / (2 * h);
    CHECK(std::abs(slope - pull.tension * dot(pull.direction, way)) < 1e-5 * stiffest * length(way));
    const spring::Pull after = spring::pull(span + h * way, {}, law, 0);
    const spring::Pull before = spring::pull(span - h * way, {}, law, 0);
    const Vec3d change = (after.tension * after.direction - before.tension * before.direction) / (2 * h);
    const spring::Block block = spring::block(span, law);
    const Vec3d expected = block.along * dot(block.direction, way) * block.direction + block.across * way;
    CHECK(length(change - expected) < 1e-5 * stiffest * length(way));
    // Damping acts along the spring alone.
    const spring::Pull damped = spring::pull(span, way, law, 0.3);
    CHECK(damped.tension - pull.tension == doctest::Approx(0.3 * dot(pull.direction, way)));
  }
  CHECK(spring::pull({0, 0, 1e-10}, {1, 1, 1}, {1, 100}, 1).tension == 0);  // too short to have a direction
  CHECK(spring::block({0, 0, 0.5}, {1, 100}).across == 0);                  // pressed: nothing indefinite
}
