// Cloth that is drawn finer than it is simulated.
#include <cstring>

#include "base/random.hpp"
#include "gpu/readback.hpp"
#include "mesh/subdivided_grid.hpp"
#include "picture/offscreen.hpp"
#include "render/picture.hpp"
#include "render/sheet.hpp"

using namespace weft;
using namespace weft::render;
using picture::Image, picture::Offscreen;

namespace {

template <class T>
std::vector<T> values_of(gpu::Device& device, const gpu::RawBuffer& buffer) {
  const auto bytes = value_of(gpu::download_bytes(device, buffer.source()));
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

/// Cloths one after another, with random positions [m], velocities, stretch and contacts.
struct RandomCloths {
  GpuFixture fixture;
  std::vector<mesh::Grid> grids;
  std::array<std::vector<Vec4f>, 2> position, velocity;
  std::vector<float> stretch;
  std::array<gpu::Buffer<Vec4f>, 2> position_buffer, velocity_buffer;
  gpu::Buffer<float> stretch_buffer;
  ClothDraw draw;

  explicit RandomCloths(std::vector<mesh::Grid> all) : grids(std::move(all)) {
    Random random(7);
    const auto number = [&] { return static_cast<float>(random.uniform(-1, 1)); };
    std::uint32_t first = 0;
    for (const mesh::Grid& grid : grids) {
      draw.ranges.push_back({0, 0, std::nullopt, 1, ClothGrid{grid, first}});
      first += mesh::node_count(grid);
    }
    for (std::size_t parity = 0; parity < 2; ++parity) {
      for (std::uint32_t v = 0; v < first; ++v) {
        position[parity].push_back({number(), number(), number(), 0});
        velocity[parity].push_back({number(), number(), number(), 0});
      }
      position_buffer[parity] =
          value_of(gpu::Buffer<Vec4f>::create_from(fixture.device(), position[parity], "position"));
      velocity_buffer[parity] =
          value_of(gpu::Buffer<Vec4f>::create_from(fixture.device(), velocity[parity], "velocity"));
      draw.position[parity] = &position_buffer[parity];
      draw.velocity[parity] = &velocity_buffer[parity];
    }
    for (std::uint32_t v = 0; v < first; ++v) stretch.push_back(number());
    stretch_buffer = value_of(gpu::Buffer<float>::create_from(fixture.device(), stretch, "stretch"));
    draw.stretch = draw.contacts = &stretch_buffer;
  }

  /// All cloths upsampled in double, what `value` says of each node.
  template <class Value>
  std::vector<Vec3d> expected(std::uint32_t level, const Value& value) const {
    std::vector<Vec3d> all;
    std::size_t first = 0;
    for (const mesh::Grid& grid : grids) {
      std::vector<Vec3d> nodes;
      for (std::size_t v = 0; v < mesh::node_count(grid); ++v) nodes.push_back(value(first + v));
      const std::vector<Vec3d> fine = mesh::upsample(grid, nodes, level);
      all.insert(all.end(), fine.begin(), fine.end());
      first += nodes.size();
    }
    return all;
  }
};

/// Sums of 16 products of numbers below 1 with weights whose sizes add to less than 7² at a rim: of each
/// 2^-24 is lost.
constexpr double kRounding = 2e-6;

Settings small(View view, std::uint32_t subdivide) {
  Settings settings;
  settings.width = 200;
  settings.height = 160;
  settings.view = view;
  settings.subdivide = subdivide;
  settings.bounds = {{-1, -1, -1}, {1, 0.5F, 1}};
  return settings;
}

/// A sheet with the triangles of mesh/grid.hpp, as scenes have it.
struct GridSheet : Sheet {
  GridSheet(gpu::Device& device, std::uint32_t side, const Shape& shape) : Sheet(device, side, shape, 2) {
    mesh.triangles = mesh::grid_triangles({side, side});
    triangles.write(device, {mesh.triangles.data()->data(), 3 * mesh.triangles.size()});
    std::vector<Vec4f> normals;
    for (const Vec3f& n : vertex_normals(mesh)) normals.push_back(Vec4f::from(n, 0));
    normal.write(device, normals);
  }
};

/// The sheet over a floor that shows its shadow.
Image picture_of(gpu::Device& device, const Sheet& sheet, View view, std::uint32_t subdivide) {
  Inputs inputs;
  inputs.cloth = sheet.draw();
  inputs.planes = {{{0, -1, 0}, {0, 1, 0}}};
  auto offscreen = value_of(Offscreen::create(device, small(view, subdivide), inputs));
  return value_of(offscreen.draw(0));
}

Vec3d hills(double u, double v) {
  return {2 * u - 1, 0.25 * std::sin(9 * u + 2 * v) * std::cos(6 * v), 1 - 2 * v};
}

}  // namespace

TEST_CASE("the kernel finds the vertices that double precision finds, of every cloth and either parity") {
  RandomCloths cloths({{7, 4}, {2, 9}, {40, 23}});
  for (std::uint32_t level = 1; level <= 4; ++level) {
    const auto fine = value_of(FineCloth::create(cloths.fixture.device(), cloths.draw, level));
    for (const std::uint32_t parity : {0U, 1U}) {
      gpu::CommandList list;
      fine->record(list, parity, View::Textured);
      REQUIRE(cloths.fixture.device().submit(list));
      const auto found = values_of<Vec4f>(cloths.fixture.device(), *fine->draw().position[parity]);
      const auto expected = cloths.expected(
          level, [&](std::size_t v) { return cloths.position[parity][v].xyz().to<double>(); });
      REQUIRE(found.size() == expected.size());
      double most = 0;
      for (std::size_t v = 0; v < found.size(); ++v)
        most = std::max(most, length(found[v].xyz().to<double>() - expected[v]));
      CHECK(most < kRounding);
    }
  }
}

TEST_CASE("what a view shows of nodes is upsampled as their places are") {
  RandomCloths cloths({{7, 4}, {2, 9}});
  gpu::Device& device = cloths.fixture.device();
  const auto fine = value_of(FineCloth::create(device, cloths.draw, 2));
  for (const View view : {View::Stretch, View::Velocity, View::Contacts})
    REQUIRE(fine->add_field(device, view));
  const auto lengths = cloths.expected(2, [&](std::size_t v) { return Vec3d{cloths.stretch[v], 0, 0}; });
  for (const View view : {View::Stretch, View::Contacts}) {
    gpu::CommandList list;
    fine->record(list, 0, view);
    REQUIRE(device.submit(list));
    const auto found =
        values_of<float>(device, view == View::Stretch ? *fine->draw().stretch : *fine->draw().contacts);
    REQUIRE(found.size() == lengths.size());
    for (std::size_t v = 0; v < found.size(); ++v) CHECK(std::abs(found[v] - lengths[v].x) < kRounding);
  }
  for (const std::uint32_t parity : {0U, 1U}) {
    gpu::CommandList list;
    fine->record(list, parity, View::Velocity);
    REQUIRE(device.submit(list));
    const auto found = values_of<Vec4f>(device, *fine->draw().velocity[parity]);
    const auto expected =
        cloths.expected(2, [&](std::size_t v) { return cloths.velocity[parity][v].xyz().to<double>(); });
    REQUIRE(found.size() == expected.size());
    for (std::size_t v = 0; v < found.size(); ++v)
      CHECK(length(found[v].xyz().to<double>() - expected[v]) < kRounding);
  }
}

TEST_CASE("the normals of a paraboloid are its own, and the triangles face along them") {
  GpuFixture fixture;
  gpu::Device& device = fixture.device();
  const mesh::Grid grid{5, 7, 1, 1};
  std::vector<Vec4f> nodes;  // z = x² - 3 x y / 2, on the drawing of mesh/grid.hpp: y goes down
  for (std::uint32_t j = 0; j < grid.ny; ++j)
    for (std::uint32_t i = 0; i < grid.nx; ++i) {
      const double x = i / 4.0, y = -(j / 6.0);
      nodes.push_back(Vec4f::from(Vec3d{x, y, x * x - 1.5 * x * y}.to<float>(), 0));
    }
  const auto position = value_of(gpu::Buffer<Vec4f>::create_from(device, nodes, "position"));
  ClothDraw draw;
  draw.position = {&position, &position};
  draw.ranges = {{0, 0, std::nullopt, 1, ClothGrid{grid, 0}}};
  const auto fine = value_of(FineCloth::create(device, draw, 3));
  gpu::CommandList list;
  fine->record(list, 0, View::Textured);
  REQUIRE(device.submit(list));
  const auto places = values_of<Vec4f>(device, *fine->draw().position[0]);
  const auto normals = values_of<Vec4f>(device, *fine->draw().normal);
  for (std::size_t v = 0; v < places.size(); ++v) {
    const double x = places[v].x, y = places[v].y;
    const Vec3d upright{-(2 * x - 1.5 * y), 1.5 * x, 1};
    CHECK(length(normals[v].xyz().to<double>() - upright / length(upright)) < 1e-5);
  }
  const auto triangles = values_of<std::uint32_t>(device, *fine->draw().triangles);
  REQUIRE(triangles.size() == 3 * fine->draw().ranges[0].triangle_count);
  CHECK(fine->draw().ranges[0].triangle_count == 2 * 32 * 48);
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const Vec3f a = places[triangles[t]].xyz();
    const Vec3f face = cross(places[triangles[t + 1]].xyz() - a, places[triangles[t + 2]].xyz() - a);
    CHECK(dot(face, normals[triangles[t]].xyz()) > 0);
  }
}

TEST_CASE("a flat sheet looks the same however often its cells are halved, in every view without lines") {
  GpuFixture fixture;
  const auto flat = [](double u, double v) { return Vec3d{2 * u - 1, 0.9 * v - 0.7, 1 - 2 * v}; };
  const GridSheet sheet(fixture.device(), 9, flat);
  for (const View view : {View::Textured, View::Normals, View::Stretch, View::Velocity, View::Contacts}) {
    CAPTURE(std::string(scene::name_of(view)));
    const Image once = picture_of(fixture.device(), sheet, view, 0);
    CHECK(color_count(once) > 20);
    CHECK(difference(once, picture_of(fixture.device(), sheet, view, 3), 6) <=
          32);  // of 32,000 pixels: samples on the outline
  }
}

TEST_CASE("a hilly sheet of few nodes, subdivided, looks nearly like one of many: its shape and its shadow") {
  GpuFixture fixture;
  gpu::Device& device = fixture.device();
  const GridSheet few(device, 15, hills), many(device, 14 * 8 + 1, hills);
  const Image true_picture = picture_of(device, many, View::Textured, 0);
  const std::size_t coarse = difference(picture_of(device, few, View::Textured, 0), true_picture, 16);
  const std::size_t fine = difference(picture_of(device, few, View::Textured, 3), true_picture, 16);
  CAPTURE(coarse);
  CAPTURE(fine);
  CHECK(coarse > 500);
  CHECK(4 * fine < coarse);
}

TEST_CASE("a finer mesh that the adapter cannot hold is refused before anything is made, with both numbers") {
  GpuFixture fixture;
  gpu::Device& device = fixture.device();
  const auto position = value_of(gpu::Buffer<Vec4f>::create(device, 4, "position"));
  ClothDraw draw;
  draw.position = {&position, &position};
  draw.ranges = {{0, 0, std::nullopt, 1, ClothGrid{{16384, 16384}, 0}}};
  const std::uint64_t before = device.allocated_bytes();
  const auto refused = FineCloth::create(device, draw, 4);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().kind == ErrorKind::Limit);
  CHECK(refused.error().message.find(
            "With render.subdivide 4 the cloth has 68711612641 vertices, and its largest buffer needs " +
            std::to_string(24ULL * 262128 * 262128) + " bytes") != std::string::npos);
  CHECK(refused.error().message.find("maxStorageBufferBindingSize of " +
                                     std::to_string(device.limits().max_storage_binding_size)) !=
        std::string::npos);
  CHECK(device.allocated_bytes() == before);
  draw.ranges[0].grid.reset();
  CHECK(FineCloth::create(device, draw, 1).error().kind == ErrorKind::Shape);
}
