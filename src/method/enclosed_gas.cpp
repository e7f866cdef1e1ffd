#include "method/enclosed_gas.hpp"

#include <algorithm>

#include "method/corners.hpp"

namespace weft {
namespace {

/// What the kernels read of a model's gases.
struct GasLists {
  std::vector<Gas> gases;
  std::vector<GasChunk> chunks;
  std::vector<AirTriangle> triangles;
};

GasLists lists_of(const Model& model) {
  GasLists lists;
  for (const Body& body : model.bodies) {
    if (!body.gas) continue;
    const auto gas = static_cast<std::uint32_t>(lists.gases.size());
    const auto first_chunk = static_cast<std::uint32_t>(lists.chunks.size());
    for (std::uint32_t node = 0; node < body.vertex_count; node += kGasChunk)
      lists.chunks.push_back({gas, body.first_vertex + node, std::min(kGasChunk, body.vertex_count - node)});
    lists.gases.push_back(
        {body.first_vertex, first_chunk, static_cast<std::uint32_t>(lists.chunks.size()) - first_chunk,
         static_cast<float>(body.gas->rest_volume), static_cast<float>(body.gas->rest_pressure),
         static_cast<float>(body.gas->rest_gauge)});
    for (std::uint32_t t = 0; t < body.triangle_count; ++t)
      lists.triangles.push_back({model.triangles[body.first_triangle + t], {1.0 / 3, 1.0 / 3, 1.0 / 3}});
  }
  return lists;
}

}  // namespace

Result<EnclosedGas> EnclosedGas::create(const SolverInputs& inputs, At at) {
  EnclosedGas made;
  const GasLists lists = lists_of(inputs.model.host);
  if (lists.gases.empty()) return made;
  gpu::Device& device = inputs.device;
  WEFT_SET(made.corners_, corners_around(device, inputs.model.vertex_count(), lists.triangles));
  WEFT_SET(made.chunks_, gpu::Buffer<GasChunk>::create_from(device, lists.chunks, "gas chunks"));
  WEFT_SET(made.gases_, gpu::Buffer<Gas>::create_from(device, lists.gases, "gases"));
  WEFT_SET(made.slopes_, gpu::Buffer<Vec4f>::create(device, inputs.model.vertex_count(), "gas slopes"));
  WEFT_SET(made.volumes_, gpu::Buffer<float>::create(device, lists.chunks.size(), "gas volumes"));
  const State& state = inputs.state;
  WEFT_TRY(volume,
           gpu::create_shared_kernel(device, "method/gas_volumes.wgsl",
                                     {{"kAhead", at == At::Ahead ? 1.0 : 0.0}}, inputs.workgroup_size));
  WEFT_SET(made.volume_, gpu::Dispatch::create_by_parity(
                             volume, volume->workgroups_of(std::uint64_t{kGasChunk} * lists.chunks.size()),
                             [&](std::size_t p) -> gpu::Dispatch::Bindings {
                               return {state.steps,       made.corners_,     made.chunks_, made.gases_,
                                       state.position[p], state.velocity[p], made.slopes_, made.volumes_};
                             }));
  WEFT_TRY(pressure,
           gpu::create_shared_kernel(device, "method/gas_pressures.wgsl", {}, inputs.workgroup_size));
  WEFT_SET(made.pressure_,
           gpu::Dispatch::create(
               pressure, pressure->workgroups_of(std::uint64_t{inputs.workgroup_size} * lists.gases.size()),
               {made.volumes_, made.gases_}));
  return made;
}

void EnclosedGas::record(gpu::ComputePass& pass) const {
  volume_.record(pass);
  pressure_.record(pass);
}

}  // namespace weft
