// Read back by tinygltf.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "fake_run.hpp"
#include "mesh/glb_animation.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#include <tiny_gltf.h>
#pragma GCC diagnostic pop

using namespace weft;

namespace {

tinygltf::Model model_of(const std::string& bytes) {
  tinygltf::TinyGLTF reader;
  tinygltf::Model model;
  std::string error, warning;
  const bool read = reader.LoadBinaryFromMemory(&model, &error, &warning,
                                                reinterpret_cast<const unsigned char*>(bytes.data()),
                                                static_cast<unsigned>(bytes.size()));
  REQUIRE_MESSAGE(read, error);
  CHECK(warning == "");
  return model;
}

/// The values of an accessor of floats.
std::vector<float> floats(const tinygltf::Model& model, int number) {
  const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(number));
  CHECK(accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT);
  const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
  const std::size_t width =
      static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
  std::vector<float> values(accessor.count * width);
  const std::vector<unsigned char>& data = model.buffers.at(0).data;
  REQUIRE(accessor.byteOffset + 4 * values.size() <= view.byteLength);
  REQUIRE(view.byteOffset + view.byteLength <= data.size());
  std::memcpy(values.data(), data.data() + view.byteOffset + accessor.byteOffset, 4 * values.size());
  return values;
}

std::vector<std::uint32_t> indices(const tinygltf::Model& model, int number) {
  const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(number));
  CHECK(accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
  const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
  std::vector<std::uint32_t> values(accessor.count);
  REQUIRE(accessor.byteOffset + 4 * values.size() <= view.byteLength);
  std::memcpy(values.data(), model.buffers.at(0).data.data() + view.byteOffset + accessor.byteOffset,
              4 * values.size());
  return values;
}

/// Whether what a viewer computes for this weight, in f32, is the value: the difference is rounded, then the sum.
bool reaches(float base, float change, float wanted) {
  constexpr float kHalf = std::numeric_limits<float>::epsilon() / 2;  // of a value's own size
  const float sum = base + change;
  return change == wanted - base && std::abs(static_cast<double>(sum) - static_cast<double>(wanted)) <=
                                        static_cast<double>(kHalf) * (std::abs(static_cast<double>(change)) +
                                                                      std::abs(static_cast<double>(sum)));
}

}  // namespace

TEST_CASE("a GLB animation has each mesh at its time, as tinygltf reads it") {
  const std::vector<std::uint32_t> frames = {4, 6, 8, 9, 12};  // as of a run that was resumed
  for (const char* format : {"obj", "ply"}) {
    const FakeRun run(frames, format);
    const tinygltf::Model model = model_of(run.bytes_of("glb"));
    REQUIRE(model.animations.size() == 1);
    const tinygltf::Animation& animation = model.animations[0];
    REQUIRE(animation.samplers.size() == 1);
    CHECK(animation.samplers[0].interpolation == "LINEAR");
    const std::vector<float> times = floats(model, animation.samplers[0].input),
                             weights = floats(model, animation.samplers[0].output);
    const std::size_t shapes = frames.size(), targets = shapes - 1;
    REQUIRE(times.size() == shapes);
    REQUIRE(weights.size() == shapes * targets);
    for (std::size_t k = 0; k < shapes; ++k) {
      CHECK(times[k] == static_cast<float>((frames[k] - frames[0]) * FakeRun::kFrame));
      for (std::size_t t = 0; t < targets; ++t) CHECK(weights[k * targets + t] == (t + 1 == k ? 1.0F : 0.0F));
    }
    const auto& range = model.accessors[static_cast<std::size_t>(animation.samplers[0].input)];
    CHECK(range.minValues == std::vector<double>{0});
    CHECK(range.maxValues.at(0) == doctest::Approx(8 * FakeRun::kFrame));

    REQUIRE(animation.channels.size() == 2);
    REQUIRE(model.scenes.at(0).nodes == std::vector<int>{0, 1});
    std::size_t first_vertex = 0, first_triangle = 0;
    for (std::size_t p = 0; p < 2; ++p) {
      CAPTURE(p);
      const mesh::MeshPart& part = run.parts()[p];
      CHECK(animation.channels[p].target_node == static_cast<int>(p));
      CHECK(animation.channels[p].target_path == "weights");
      CHECK(animation.channels[p].sampler == 0);
      CHECK(model.nodes.at(p).mesh == static_cast<int>(p));
      CHECK(model.nodes[p].name == part.name);
      CHECK(model.meshes.at(p).name == part.name);
      const tinygltf::Primitive& primitive = model.meshes[p].primitives.at(0);
      REQUIRE(primitive.targets.size() == targets);
      const tinygltf::Material& material = model.materials.at(static_cast<std::size_t>(primitive.material));
      CHECK(material.name == part.name);
      CHECK(material.doubleSided);
      CHECK(material.pbrMetallicRoughness.baseColorFactor ==
            (p == 0 ? std::vector<double>{1, 1, 1, 1} : std::vector<double>{0.25, 0.5, 1, 1}));
      const std::vector<float> base = floats(model, primitive.attributes.at("POSITION")),
                               normal = floats(model, primitive.attributes.at("NORMAL")),
                               texture = floats(model, primitive.attributes.at("TEXCOORD_0"));
      REQUIRE(base.size() == std::size_t{3} * part.vertices);
      for (std::size_t v = 0; v < part.vertices; ++v) {
        for (std::size_t a = 0; a < 3; ++a)
          CHECK(base[3 * v + a] == run.shape(0).positions[first_vertex + v][static_cast<int>(a)]);
        CHECK(texture[2 * v] == run.texture()[first_vertex + v][0]);
        CHECK(texture[2 * v + 1] == 1 - run.texture()[first_vertex + v][1]);
      }
      for (std::size_t k = 1; k < shapes; ++k) {
        const auto& target = primitive.targets[k - 1];
        const std::vector<float> moved = floats(model, target.at("POSITION")),
                                 turned = floats(model, target.at("NORMAL"));
        const std::vector<Vec3f> normals = mesh::smooth_normals(run.shape(k));
        std::vector<double> low(3, 1e9), high(3, -1e9);
        for (std::size_t v = 0; v < part.vertices; ++v)
          for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t at = 3 * v + a;
            const int axis = static_cast<int>(a);
            CHECK(reaches(base[at], moved[at], run.shape(k).positions[first_vertex + v][axis]));
            CHECK(reaches(normal[at], turned[at], normals[first_vertex + v][axis]));
            low[a] = std::min(low[a], static_cast<double>(moved[at]));
            high[a] = std::max(high[a], static_cast<double>(moved[at]));
          }
        const auto& bounds = model.accessors[static_cast<std::size_t>(target.at("POSITION"))];
        for (std::size_t a = 0; a < 3; ++a) {
          CHECK(static_cast<float>(bounds.minValues.at(a)) == static_cast<float>(low[a]));
          CHECK(static_cast<float>(bounds.maxValues.at(a)) == static_cast<float>(high[a]));
        }
      }
      const std::vector<std::uint32_t> corners = indices(model, primitive.indices);
      REQUIRE(corners.size() == std::size_t{3} * part.triangles);
      for (std::size_t c = 0; c < corners.size(); ++c)
        CHECK(corners[c] + first_vertex == run.shape(0).triangles[first_triangle + c / 3][c % 3]);
      first_vertex += part.vertices;
      first_triangle += part.triangles;
    }
  }
}

TEST_CASE("a single mesh is a GLB file without an animation") {
  const FakeRun run({3});
  const tinygltf::Model model = model_of(run.bytes_of("glb"));
  CHECK(model.animations.empty());
  REQUIRE(model.meshes.size() == 2);
  CHECK(model.meshes[0].primitives.at(0).targets.empty());
  CHECK(floats(model, model.meshes[1].primitives.at(0).attributes.at("POSITION")).size() == 3 * 6);
}

TEST_CASE(
    "an animation over the 32 bits of a GLB header is refused with both numbers, and nothing is written") {
  const FakeRun run({0});
  constexpr std::size_t kMeshes = 33000;  // of which the weights alone have 4 * 33000 * 32999 bytes
  for (std::uint32_t k = 1; k < kMeshes; ++k)
    std::filesystem::create_symlink("mesh_00000.obj", run.run() + "/" + mesh_name(k, "obj"));
  const auto written = run.write("glb", "a.glb");
  REQUIRE_FALSE(written);
  CHECK(written.error().kind == ErrorKind::Limit);
  const std::uint64_t least =
      24 * std::uint64_t{26} * kMeshes + 12 * std::uint64_t{28} + 4 * kMeshes * (kMeshes - 1);
  CHECK(written.error().message == "33000 meshes of 26 vertices take " + std::to_string(least) +
                                       " bytes as GLB, more than its limit of 4294967292; --every leaves "
                                       "meshes out, and pc2 and mdd have no "
                                       "such limit.");
  CHECK(run.names() == std::vector<std::string>{"run"});
  CHECK(run.open({{}, {}, 2}).count() == 16500);
}

TEST_CASE("the size that a GLB animation says beforehand is that of its file") {
  const FakeRun run({0, 1, 2, 5});
  const RunMeshes meshes = run.open();
  std::vector<float> times;
  for (std::size_t k = 0; k < meshes.count(); ++k) times.push_back(static_cast<float>(meshes.time(k)));
  const mesh::GlbAnimation animation(meshes.shape(), meshes.attributes(), meshes.parts().parts, times);
  CHECK(animation.size() == run.bytes_of("glb").size());
  CHECK(mesh::GlbAnimation::least_size(26, 28, 4) < animation.size());
}
