// The inputs of a picture: buffers of the state, where they lie, and the obstacles.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "gpu/buffer.hpp"
#include "mesh/deformation.hpp"
#include "mesh/grid.hpp"
#include "scene/scene.hpp"

namespace weft::render {

/// A cloth that is a grid: what can be drawn finer.
struct ClothGrid {
  mesh::Grid shape;
  std::uint32_t first_vertex = 0;
};

/// The triangles of one cloth, and how it looks.
struct ClothRange {
  std::uint32_t first_triangle = 0, triangle_count = 0;
  std::optional<Vec3d> color;  // sRGB in [0, 1]; none: the next of a palette
  double sheet_size = 1;  // the longer side of the sheet in uv [m]: the check repeats a few times over it
  std::optional<ClothGrid> grid{};  // only where a picture subdivides
  bool woven = true;                // false: of one colour, as what is closed
  scene::Look look{};
  std::optional<std::array<double, 2>>
      rim{};  // of a grid: its width and height in uv [m]; it has a hem there
};

/// All cloths of a state. The buffers must outlive the renderer.
struct ClothDraw {
  std::array<const gpu::RawBuffer*, 2> position{};  // vertex_count x Vec4f [m]; parity says which is drawn
  const gpu::RawBuffer* normal = nullptr;           // vertex_count x Vec4f, unit
  const gpu::RawBuffer* uv = nullptr;               // vertex_count x 2 float [m]
  const gpu::RawBuffer* triangles = nullptr;        // 3 x triangle_count uint32; usage kIndex and kStorage
  const gpu::RawBuffer* stretch = nullptr;  // vertex_count x float, length / rest length; only View::Stretch
  std::array<const gpu::RawBuffer*, 2> velocity{};  // vertex_count x Vec4f [m/s]; only View::Velocity
  const gpu::RawBuffer* contacts = nullptr;         // vertex_count x float, a number; only View::Contacts
  std::vector<ClothRange> ranges;
};

/// An obstacle of triangles, in the world where the scene puts it [m].
struct ObjectDraw {
  mesh::TriangleMesh mesh;
  mesh::Deformation deformation{};  // before its motion
  std::optional<scene::ColliderMotion> motion{};
  std::optional<std::size_t> rigid{};  // the number of its collider in RigidRows, where it is a rigid body
  std::optional<std::size_t> given{};  // the same in Inputs::colliders, where a program moves it
  scene::Material material = scene::Material::Plaster;
};

/// Where rigid bodies are: a buffer that has three rows of a transform for each collider, as placement.wgsl reads them.
struct RigidRows {
  const gpu::RawBuffer* words = nullptr;  // null: there are none
  std::uint64_t first = 0, stride = 0;    // of collider 0, and from one to the next [bytes]
};

/// The obstacles are copied at creation; those with a motion move with Renderer::set_time.
struct Inputs {
  ClothDraw cloth;
  std::vector<ObjectDraw> objects;
  std::vector<scene::ColliderSphere> spheres;
  std::vector<scene::ColliderCapsule> capsules;
  std::vector<scene::ColliderBox> boxes;
  std::vector<ObjectDraw> hulls;  // convex; drawn with sharp edges, as boxes are
  std::vector<scene::ColliderPlane> planes;
  RigidRows rigid;
  // Of each sphere, capsule, box and plane the number of its collider; may be left out where none is rigid or given.
  std::vector<std::size_t> sphere_colliders{}, capsule_colliders{}, box_colliders{}, plane_colliders{};
  /// The scene's, whose motions a program goes on giving: they must outlive the renderer. Null: it moves none.
  const std::vector<scene::Collider>* colliders = nullptr;
};

}  // namespace weft::render
