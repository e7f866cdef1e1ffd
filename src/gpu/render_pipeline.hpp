#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "gpu/kernel.hpp"

namespace weft::gpu {

/// A vertex and a fragment shader of one WGSL file. Vertices are read from storage buffers by their index
/// (@builtin(vertex_index)), so there are no vertex buffers.
class RenderPipeline {
 public:
  RenderPipeline() = default;
  /// Compiles src/`path`, unless the device has done so already for the same info.
  /// Errors  Shader: it does not compile, or does not fit the formats.
  static Result<RenderPipeline> create(Device& device, const std::string& path,
                                       const RenderPipelineInfo& info);

  /// Errors  Shape: another number of things than the shader binds.
  Result<BindGroup> bind(std::initializer_list<Binding> sources) const;
  Id id() const { return compiled_ ? compiled_->pipeline.id() : 0; }

 private:
  Device* device_ = nullptr;
  std::string label_;
  SharedPipeline compiled_;
};

}  // namespace weft::gpu
