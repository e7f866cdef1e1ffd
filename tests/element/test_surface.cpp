// Normals and stretch against double precision, on grids and meshes.
#include <algorithm>
#include <bit>
#include <cmath>

#include "base/random.hpp"
#include "gpu/gpu_fixture.hpp"
#include "gpu/readback.hpp"
#include "mesh/primitives.hpp"
#include "scene/load.hpp"
#include "state/surface.hpp"

using namespace weft;

namespace {

Model model_of(const std::string& cloth, const mesh::TriangleMesh& mesh = {}) {
  const auto scene =
      scene::parse_scene(R"({"format": "weft-scene/1", "cloths": [)" + cloth + "]}", "test.json");
  REQUIRE(scene);
  auto model = build_model(*scene, std::vector<mesh::TriangleMesh>(scene->cloths.size(), mesh));
  REQUIRE(model);
  return std::move(*model);
}

void check_surface(Model host, std::uint64_t seed) {
  GpuFixture fixture;
  gpu::Device& device = fixture.device();
  auto model = GpuModel::create(device, std::move(host));
  REQUIRE(model);
  auto state = State::create(device, model->host, 1);
  REQUIRE(state);
  Random random(seed);
  std::vector<Vec4f> position(model->vertex_count());
  for (std::size_t i = 0; i < position.size(); ++i) {
    const Vec3f rest = model->host.rest_position[i].to<float>();
    const auto draw = [&] { return static_cast<float>(random.uniform(-0.03, 0.03)); };
    position[i] = {rest.x + draw(), rest.y + draw(), rest.z + draw(), 1};
  }
  for (const std::uint32_t parity : {0U, 1U}) {
    state->position[parity].write(device, position);
    auto surface = Surface::create(device, *model, *state);
    REQUIRE(surface);
    gpu::CommandList list;
    list.clear(state->statistics.source());
    {
      gpu::ComputePass pass(list, "surface");
      pass.set_step(0, parity);
      surface->record(pass);
    }
    REQUIRE(device.submit(list));
    const auto normal = gpu::download(device, surface->normal());
    const auto stretch = gpu::download(device, surface->stretch());
    const auto statistics = gpu::download(device, state->statistics);
    REQUIRE(normal);
    std::vector<Vec3d> sums(position.size());
    std::vector<double> largest(position.size(), 0.0);
    const Model& built = model->host;
    for (const Body& body : built.bodies)
      for (std::uint32_t t = 0; t < body.triangle_count; ++t) {
        const mesh::Triangle& triangle = built.triangles[body.first_triangle + t];
        const auto at = [&](int corner) {
          return position[triangle[static_cast<std::size_t>(corner)]].xyz().to<double>();
        };
        const Vec3d area = cross(at(1) - at(0), at(2) - at(0));
        for (int corner = 0; corner < 3; ++corner) {
          const std::uint32_t a = triangle[static_cast<std::size_t>(corner)],
                              b = triangle[static_cast<std::size_t>((corner + 1) % 3)];
          sums[a] += area;
          const std::uint32_t apart = std::max(a, b) - std::min(a, b);
          if (body.grid && apart != 1 && apart != body.grid->nx) continue;  // a quad's diagonal
          const Vec3d rest = built.rest_position[b].to<float>().to<double>() -
                             built.rest_position[a].to<float>().to<double>();
          const double ratio =
              length(position[b].xyz().to<double>() - position[a].xyz().to<double>()) / length(rest);
          largest[a] = std::max(largest[a], ratio);
          largest[b] = std::max(largest[b], ratio);
        }
      }
    for (std::size_t i = 0; i < position.size(); ++i) {
      // A sum of up to 8 cross products of spans of 0.1 m between coordinates of 1 m: 1e-7 / 0.1 of each,
      // doubled.
      CHECK(length((*normal)[i].xyz().to<double>() - sums[i] / length(sums[i])) < 3e-5);
      CHECK(static_cast<double>((*stretch)[i]) == doctest::Approx(largest[i]).epsilon(1e-5).scale(0));
    }
    const double reported =
        static_cast<double>(std::bit_cast<float>((*statistics)[offsetof(Statistics, max_stretch) / 4]));
    CHECK(reported ==
          doctest::Approx(*std::max_element(largest.begin(), largest.end())).epsilon(1e-5).scale(0));
  }
}

}  // namespace

TEST_CASE("normals and stretch of grids equal double precision; the diagonals of a grid do not count") {
  check_surface(
      model_of(
          R"({"grid": [11, 8], "size": [1, 0.8], "density": 1}, {"grid": [5, 9], "size": [0.5, 1], "density": 1})"),
      1);
}
TEST_CASE("normals and stretch of a mesh equal double precision, all edges counted") {
  check_surface(model_of(R"({"mesh": "a.obj", "density": 1})", mesh::make_sphere(14, 9)), 2);
}
