// A GLB file of a box that an animation moves.
#pragma once

#include <string>
#include <vector>

#include "mesh/animated_mesh.hpp"
#include "mesh/glb_chunks.hpp"
#include "mesh/primitives.hpp"

namespace weft {

/// A box whose animation "lift" takes it along y, straight between these heights [m] at these times [s].
inline std::vector<std::byte> animated_box(const Vec3d& size, const std::vector<float>& times,
                                           const std::vector<float>& heights) {
  const mesh::TriangleMesh box = mesh::make_box(size);
  std::string binary;
  const auto add = [&](const void* data, std::size_t bytes) {
    binary.append(static_cast<const char*>(data), bytes);
  };
  add(box.positions.data(), sizeof(Vec3f) * box.positions.size());
  add(box.triangles.data(), sizeof(mesh::Triangle) * box.triangles.size());
  add(times.data(), sizeof(float) * times.size());
  for (const float height : heights) {
    const Vec3f at{0, height, 0};
    add(&at, sizeof at);
  }
  const auto text = [](std::size_t number) { return std::to_string(number); };
  const std::size_t points = sizeof(Vec3f) * box.positions.size(),
                    corners = sizeof(mesh::Triangle) * box.triangles.size(),
                    keys = sizeof(float) * times.size();
  const std::string json =
      R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
      R"("animations":[{"name":"lift","channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],)"
      R"("samplers":[{"input":2,"output":3}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" +
      text(box.positions.size()) + R"(,"type":"VEC3"},{"bufferView":1,"componentType":5125,"count":)" +
      text(3 * box.triangles.size()) + R"(,"type":"SCALAR"},{"bufferView":2,"componentType":5126,"count":)" +
      text(times.size()) + R"(,"type":"SCALAR"},{"bufferView":3,"componentType":5126,"count":)" +
      text(times.size()) + R"(,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":)" + text(points) +
      R"(},{"buffer":0,"byteOffset":)" + text(points) + R"(,"byteLength":)" + text(corners) +
      R"(},{"buffer":0,"byteOffset":)" + text(points + corners) + R"(,"byteLength":)" + text(keys) +
      R"(},{"buffer":0,"byteOffset":)" + text(points + corners + keys) + R"(,"byteLength":)" +
      text(3 * keys) + R"(}],"buffers":[{"byteLength":)" + text(binary.size()) + "}]}";
  std::vector<std::byte> bytes = mesh::glb_before_binary(json, binary.size());
  for (const char c : binary) bytes.push_back(static_cast<std::byte>(c));
  return bytes;
}

}  // namespace weft
