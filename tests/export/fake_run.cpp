#include "fake_run.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "base/file.hpp"
#include "base/random.hpp"
#include "mesh/grid.hpp"
#include "mesh/obj.hpp"
#include "mesh/ply.hpp"

namespace weft {
namespace {

constexpr std::uint32_t kSides[2][2] = {{5, 4}, {3, 2}};

}  // namespace

FakeRun::FakeRun(std::vector<std::uint32_t> frames, const std::string& format) {
  Random random(7);
  std::vector<mesh::Triangle> triangles;
  std::uint32_t vertices = 0;
  for (const auto& [nx, ny] : kSides) {
    const mesh::Grid grid{nx, ny};
    for (const mesh::Triangle& t : mesh::grid_triangles(grid))
      triangles.push_back({vertices + t[0], vertices + t[1], vertices + t[2]});
    parts_.parts.push_back(
        {"cloth \"" + std::to_string(vertices) + "\"", nx * ny, 2 * (nx - 1) * (ny - 1), {}});
    vertices += nx * ny;
  }
  parts_.parts[1].color = {0.25, 0.5, 1};
  parts_.frame = kFrame;
  const auto between = [&](double low, double high) { return static_cast<float>(random.uniform(low, high)); };
  for (std::uint32_t v = 0; v < vertices; ++v) texture_.push_back({between(0, 1), between(0, 1)});
  REQUIRE(make_folder(run()));
  REQUIRE(write_file(run() + "/meshes.json", parts_json(parts_)));
  for (const std::uint32_t frame : frames) {
    mesh::TriangleMesh shape{{}, triangles};
    for (std::uint32_t v = 0; v < vertices; ++v)
      shape.positions.push_back({between(-2, 2), between(-1e-3, 1e-3), between(90, 100)});
    const mesh::VertexAttributes attributes{mesh::smooth_normals(shape), texture_};
    const auto bytes =
        format == "ply" ? mesh::write_ply(shape, {}, attributes) : mesh::write_obj(shape, attributes);
    REQUIRE(write_file(run() + "/" + mesh_name(frame, format), bytes));
    shapes_.push_back(std::move(shape));
  }
}

RunMeshes FakeRun::open(const MeshRange& range) const {
  auto meshes = RunMeshes::open(run(), range);
  REQUIRE_MESSAGE(meshes, meshes.error().message);
  return std::move(*meshes);
}

std::string FakeRun::refusal(const MeshRange& range) const {
  const auto meshes = RunMeshes::open(run(), range);
  REQUIRE_FALSE(meshes);
  CHECK(meshes.error().kind == ErrorKind::Input);
  return meshes.error().message;
}

Result<void> FakeRun::write(const std::string& format, const std::string& file,
                            const MeshRange& range) const {
  WEFT_TRY(meshes, RunMeshes::open(run(), range));
  WEFT_TRY(exporter, make_exporter(format, path(file), meshes));
  for (std::size_t k = 0; k < meshes.count(); ++k) {
    WEFT_TRY(shape, meshes.read(k));
    WEFT_CHECK(exporter->add(shape));
  }
  return exporter->finish();
}

std::string FakeRun::bytes_of(const std::string& format, const MeshRange& range) const {
  const auto written = write(format, "a." + format, range);
  REQUIRE_MESSAGE(written, written.error().message);
  return text_of_file(path("a." + format));
}

std::vector<std::string> FakeRun::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path("")))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string text_of_file(const std::string& path) {
  const auto bytes = read_file(path, std::uint64_t{1} << 30U);
  REQUIRE_MESSAGE(bytes, bytes.error().message);
  return {reinterpret_cast<const char*>(bytes.value().data()), bytes.value().size()};
}

}  // namespace weft
