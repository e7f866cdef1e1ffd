// Patches of a grid that are open: which ones the search takes to be so, that it leaves out their own pairs and no
// others, and that these are far apart.
#include "contact/open_patches.hpp"
#include "contact/proximity/triangle_order.hpp"
#include "contact/record_checks.hpp"

using namespace weft;

namespace {

/// A square sheet of so many quads a side, 1 m long, with the lengths that the law gives it.
SearchCase grid_of(std::uint32_t quads) {
  SearchCase made = sheet_of(2 * quads * quads);
  made.grid = mesh::Grid{quads + 1, quads + 1, 1, 1};
  const float altitude = 1.0F / (static_cast<float>(quads) * std::sqrt(2.0F));
  made.self_thickness = 0.4F * altitude;
  made.thickness = 2 * made.self_thickness;
  made.most_reach = 0.5F * (0.95F * altitude - made.self_thickness);
  made.reach = 0.5F * made.most_reach;
  made.substep = 1.0F / 480;
  made.room = {400000, 20000, 1000000};
  return made;
}

/// Bent into waves of this depth [m], the steepest where x is large, and shaken [m].
std::vector<Vec3f> waves(const std::vector<Vec3f>& flat, double depth, double shake, Random& random) {
  std::vector<Vec3f> made;
  for (const Vec3f& at : flat) {
    const Vec3d p = at.to<double>();
    made.push_back(
        (p + Vec3d{0, depth * p.x * std::sin(25 * p.x + 4 * p.z), 0} + shake * random_direction(random))
            .to<float>());
  }
  return made;
}

/// The open patches of a table, as the kernel has to see them: now, and where the motion leads [m].
std::vector<bool> open_patches(const contact::PatchTable& table, const SearchRun& run,
                               const std::vector<Vec3f>& ends) {
  std::vector<bool> open;
  for (const contact::PatchPlace& place : table.places) {
    const auto& cloth = run.setup().cloth;
    const PatchAxes axes = axes_of(place, cloth.positions);
    const double lambda = std::min(openness_of(place, cloth.positions, cloth.triangles, axes),
                                   openness_of(place, ends, cloth.triangles, axes));
    REQUIRE(std::abs(lambda - kOpen) > 1e-5);
    open.push_back(lambda > kOpen);
  }
  return open;
}

bool patch_has(const contact::PatchPlace& place, std::uint32_t vertex) {
  const std::uint32_t i = vertex % place.stride, j = vertex / place.stride,
                      first = place.patch_vertex % place.stride, below = place.patch_vertex / place.stride;
  return i >= first && i <= first + columns_of(place.patch_size) && j >= below &&
         j <= below + rows_of(place.patch_size);
}

/// Whether all vertices of a pair lie in one open patch.
bool in_open_patch(const FeatureKey& key, const contact::PatchTable& table, const std::vector<bool>& open) {
  for (std::size_t p = 0; p < table.places.size(); ++p) {
    if (!open[p]) continue;
    bool all = true;
    for (std::size_t k = 1; k < 5; ++k) all = all && patch_has(table.places[p], key[k]);
    if (all) return true;
  }
  return false;
}

double distance_of(const FeatureKey& key, const std::vector<Vec3f>& positions) {
  const auto at = [&](std::size_t k) { return positions[key[k]].to<double>(); };
  return key[0] == 1 ? reference::closest_segments(at(1), at(2), at(3), at(4)).distance
                     : reference::closest_on_triangle(at(1), at(2), at(3), at(4)).distance;
}

}  // namespace

TEST_CASE("a search leaves out pairs of open patches, which are far apart, and lists all others of the law") {
  GpuFixture fixture;
  for (const std::uint32_t quads : {16U, 19U, 26U}) {
    CAPTURE(quads);
    SearchCase setup = grid_of(quads);
    const std::vector<Vec3f> flat = setup.cloth.positions;
    SearchRun run(fixture.device(), setup);
    const contact::PatchTable table(run.model());
    Random random(quads);
    for (const double depth : {0.0, 0.03, 0.08, 0.2}) {
      CAPTURE(depth);
      std::vector<Vec3f> velocities;
      for (std::size_t v = 0; v < flat.size(); ++v)
        velocities.push_back((Vec3d{6, 2, 4} + random_direction(random)).to<float>());
      const std::vector<Vec3f> start = waves(flat, depth, 0.02 / quads, random);
      run.move(start, velocities);
      std::vector<Vec3f> ends;
      for (std::size_t v = 0; v < flat.size(); ++v)
        ends.push_back((start[v].to<double>() + setup.substep * velocities[v].to<double>()).to<float>());
      const std::vector<bool> open = open_patches(table, run, ends);
      const SearchFound found = run.run();

      const auto measured = gpu::download(fixture.device(), run.search().patches().openness());
      REQUIRE(measured);
      for (std::size_t p = 0; p < open.size(); ++p) CHECK(((*measured)[2 * p].w >= 0.6F) == open[p]);

      std::map<FeatureKey, PairCount> counts;
      add_lawful(counts, possible_pairs(found, run, 1e-6));
      for (const ListedPair& pair : found.pairs) ++counts[key_of(pair.ids)].found;
      std::size_t lawful = 0, left_out = 0, wrong = 0, near = 0;
      for (const auto& [key, count] : counts) {
        lawful += count.sure;
        if (count.found > count.sure + count.doubtful + count.beyond) ++wrong;
        if (count.found >= count.sure) continue;
        ++left_out;
        if (!in_open_patch(key, table, open)) ++wrong;
        if (distance_of(key, run.setup().cloth.positions) < (kOpen - 1e-5) * distance_of(key, run.rest()))
          ++near;
      }
      CHECK(wrong == 0);
      CHECK(near == 0);
      std::printf(
          "%u quads, waves of %g m: %zu of %zu patches are open; %zu pairs by the law, %zu left out\n", quads,
          depth, static_cast<std::size_t>(std::count(open.begin(), open.end(), true)), open.size(), lawful,
          left_out);
      CHECK(lawful > 1000);
      if (depth == 0) CHECK(left_out == lawful);
      if (depth == 0.08) CHECK(left_out > 100);
      if (depth == 0.2) CHECK(lawful - left_out > 1000);
    }
  }
}

TEST_CASE("a patch with a vertex that the scene moves is not open while something moves") {
  GpuFixture fixture;
  for (const float travel : {0.0F, 0.001F}) {
    CAPTURE(travel);
    SearchCase setup = grid_of(16);
    setup.held.assign(setup.cloth.positions.size(), false);
    setup.held[0] = true;
    setup.collider_travel = travel;
    SearchRun run(fixture.device(), setup);
    const contact::PatchTable table(run.model());
    run.run();
    const auto measured = gpu::download(fixture.device(), run.search().patches().openness());
    REQUIRE(measured);
    for (std::size_t p = 0; p < table.places.size(); ++p) {
      const bool driven = travel > 0 && patch_has(table.places[p], 0);
      CHECK((*measured)[2 * p].w == doctest::Approx(driven ? 0 : 1).epsilon(1e-5));
    }
  }
}

TEST_CASE("every cell lies in the patches of its place, and every box of the tree knows its cells") {
  Random random(3);
  for (int n = 0; n < 20; ++n) {
    Model model;
    for (std::uint32_t c = 0; c < 1 + random.below(3); ++c) {
      Body body;
      body.first_vertex = static_cast<std::uint32_t>(model.uv.size());
      body.first_triangle = static_cast<std::uint32_t>(model.triangles.size());
      const mesh::Grid grid{2 + static_cast<std::uint32_t>(random.below(40)),
                            2 + static_cast<std::uint32_t>(random.below(40)), random.uniform(0.01, 1), 1};
      for (mesh::Triangle t : mesh::grid_triangles(grid)) {
        for (std::uint32_t& v : t) v += body.first_vertex;
        model.triangles.push_back(t);
      }
      for (std::uint32_t j = 0; j < grid.ny; ++j)
        for (std::uint32_t i = 0; i < grid.nx; ++i)
          model.uv.push_back({static_cast<float>(i), static_cast<float>(j)});
      if (random.below(3) != 0) body.grid = grid;
      body.vertex_count = grid.nx * grid.ny;
      body.triangle_count = static_cast<std::uint32_t>(model.triangles.size()) - body.first_triangle;
      model.bodies.push_back(body);
    }
    const contact::PatchTable table(model);
    const std::vector<std::uint32_t> order = contact::cloth_order(model);
    const contact::ImplicitTree tree(static_cast<std::uint32_t>(order.size()));
    std::vector<contact::TreeWord> words = tree.words();
    table.write_cells(tree, order, words);
    for (std::uint32_t level = 0; level < tree.counts.size(); ++level)
      for (std::uint32_t node = 0; node < tree.counts[level]; ++node) {
        const std::uint32_t low = words[words[1 + level].x + 2 * node].w,
                            high = words[words[1 + level].x + 2 * node + 1].w;
        const std::size_t size = contact::kTreeLeafTriangles << (3 * level);
        for (std::size_t k = node * size; k < std::min(order.size(), (node + 1) * size); ++k) {
          // In a patch that has all cells of the box lie all its vertices.
          for (std::uint32_t row = (high >> 16U); row <= (high & 0xffffU) + 1; ++row)
            for (std::uint32_t column = (low >> 16U); column <= (low & 0xffffU) + 1; ++column) {
              const contact::PatchPlace& place = table.places.at(column + row * table.columns);
              const Body& body = *std::find_if(model.bodies.begin(), model.bodies.end(), [&](const Body& b) {
                return order[k] < b.first_triangle + b.triangle_count;
              });
              REQUIRE(body.grid);
              for (const std::uint32_t v : model.triangles[order[k]]) {
                const std::uint32_t first = place.patch_vertex - body.first_vertex,
                                    at = v - body.first_vertex;
                CHECK(at % place.stride >= first % place.stride);
                CHECK(at % place.stride <= first % place.stride + columns_of(place.patch_size));
                CHECK(at / place.stride >= first / place.stride);
                CHECK(at / place.stride <= first / place.stride + rows_of(place.patch_size));
              }
            }
        }
      }
    std::size_t quads = 0, expected = 0;
    for (const contact::PatchPlace& place : table.places)
      quads += columns_of(place.cell_size) * rows_of(place.cell_size);
    for (const Body& body : model.bodies) expected += body.grid ? body.triangle_count / 2 : 0;
    CHECK(quads == expected);
    for (std::uint32_t t = 0; t < table.cells.size(); ++t) {
      if (table.cells[t] == contact::kNoCell) continue;
      const contact::PatchPlace& place =
          table.places.at((table.cells[t] & 0xffffU) + (table.cells[t] >> 16U) * table.columns);
      for (const std::uint32_t v : model.triangles[t]) {
        const std::uint32_t i = (v - place.cell_vertex) % place.stride,
                            j = (v - place.cell_vertex) / place.stride;
        CHECK(i <= columns_of(place.cell_size));
        CHECK(j <= rows_of(place.cell_size));
      }
    }
  }
}
