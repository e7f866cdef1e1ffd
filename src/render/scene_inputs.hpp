// From a scene and its state to what the renderer takes.
#pragma once

#include <vector>

#include "mesh/deformation.hpp"
#include "model/model.hpp"
#include "render/inputs.hpp"
#include "state/gpu_model.hpp"
#include "state/state.hpp"

namespace weft::render {

/// Derived data of vertices for pictures.
struct VertexBuffers {
  const gpu::RawBuffer& normal;              // vertex_count x Vec4f, unit
  const gpu::RawBuffer& stretch;             // vertex_count x float
  const gpu::RawBuffer* contacts = nullptr;  // vertex_count x float; none where there are no pairs
  RigidRows rigid = {};
};

/// The inputs of a picture of a running scene.
/// Reads   objects: in the world [m], one for each mesh and box collider in order, and how each deforms (or
///         nothing at all). The model, the state and the buffers must outlive the renderer.
Inputs inputs_of(const GpuModel& model, const State& state, const VertexBuffers& buffers,
                 const scene::Scene& scene, const std::vector<mesh::TriangleMesh>& objects,
                 const std::vector<mesh::Deformation>& deformations = {});

/// The box around all that a run is likely to show: objects, the cloth at rest, hanging down by its own
/// length, and where motions take it; obstacles as they are at time 0 [m].
mesh::Bounds scene_bounds(const Model& model, const scene::Scene& scene,
                          const std::vector<mesh::TriangleMesh>& objects);

}  // namespace weft::render
