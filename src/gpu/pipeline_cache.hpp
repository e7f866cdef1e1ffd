#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/recently_used.hpp"
#include "base/result.hpp"
#include "gpu/backend.hpp"
#include "gpu/object.hpp"
#include "gpu/shader_source.hpp"
#include "gpu/types.hpp"

namespace weft::gpu {

/// What compiling a kernel gives, or the two shaders of a render pipeline. It does not change, so all who compile the
/// same share it.
struct CompiledPipeline {
  std::vector<BindingLayout> bindings;
  Object group_layout, layout, pipeline;
  bool reads_step = false;
};
using SharedPipeline = std::shared_ptr<const CompiledPipeline>;

/// The compiled kernels of a device, found by what they were compiled from: a world that is made again compiles
/// nothing. Who uses one that gives way keeps it. A world has 70 at most; constants may hold the size of a grid, so
/// their number has no bound of its own.
using KernelCache = RecentlyUsed<std::string, SharedPipeline, 256>;
/// The same of render pipelines: a scene that is drawn has 20 at most.
using RenderPipelineCache = RecentlyUsed<std::string, SharedPipeline, 64>;

/// A shader's module and what it binds: all that its pipeline is made from.
struct LaidOut {
  Object module;
  CompiledPipeline made;  // without its pipeline
};
/// `for_render`: whether its shaders draw. Errors  Shader.
Result<LaidOut> lay_out(backend::Context& context, const ShaderSource& source, const std::string& path,
                        bool for_render);

/// The pipeline of this key, or else the one that `compile` makes. Errors  as `compile`.
template <class Cache, class Compile>
Result<SharedPipeline> compiled_once(Cache& cache, const std::string& key, const Compile& compile) {
  if (const SharedPipeline* known = cache.find(key)) return *known;
  Result<CompiledPipeline> made = compile();
  if (!made) return made.error();
  return cache[key] = std::make_shared<const CompiledPipeline>(std::move(*made));
}

/// All that a pipeline is compiled from. Constants to the bit.
std::string pipeline_key(const std::string& text, const std::string& path,
                         std::span<const Constant> constants);

}  // namespace weft::gpu
