#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "contact/pushes/object_triangles.hpp"
#include "gpu/kernel.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// Mirror of PairRange in src/contact/pushes/paper.wgsl; one in each 256 bytes, WebGPU's offset
/// alignment.
struct PairRange {
  std::uint32_t first = 0, count = 0, chunk = 0;
  std::uint32_t padding[61] = {};
};
static_assert(sizeof(PairRange) == 256);

/// Contacts by brute force: every cloth triangle against every object triangle. A dispatch takes a range of
/// object triangles, so that none lasts long enough for a watchdog to end it. Reads   state.steps;
/// state.position [m]: predicted and previous; model.triangles. Writes  contacts.pushes [m * push_scale;
/// count], state.statistics: added to. Errors  Shader, Limit, OutOfMemory. Source: Sung et al.
class PairsPaper {
 public:
  PairsPaper() = default;
  static Result<PairsPaper> create(gpu::Device& device, const GpuModel& model, const State& state,
                                   const Contacts& contacts, std::span<const ObjectTriangle> triangles,
                                   std::uint64_t max_pairs, std::uint32_t workgroup_size);
  void record(gpu::ComputePass& pass) const;

 private:
  struct Dispatch {
    std::array<gpu::BindGroup, 2> groups;  // by parity
    std::uint32_t chunks = 0;              // of object triangles: workgroups along y
  };

  gpu::Kernel kernel_;
  gpu::Buffer<ObjectTriangle> triangles_;
  gpu::Buffer<std::uint32_t> ids_;
  gpu::RawBuffer ranges_;
  std::vector<Dispatch> dispatches_;
  std::uint32_t workgroups_ = 0;  // along x, over the cloth triangles
};

}  // namespace weft::contact
