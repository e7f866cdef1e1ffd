#include "gpu/kernel.hpp"

#include <algorithm>
#include <cassert>
#ifndef __EMSCRIPTEN__
#include <thread>
#endif

namespace weft::gpu {

Result<BindGroup> BindGroup::create(Device& device, Id layout, std::span<const BindingLayout> bindings,
                                    std::span<const Binding> sources, const std::string& label) {
  if (sources.size() != bindings.size())
    return shape_error("Shader %s binds %zu things, not %zu.", label.c_str(), bindings.size(),
                       sources.size());
  std::vector<BindingSource> list;
  for (const Binding& binding : sources) list.push_back(binding.source);
  WEFT_TRY(id, backend::create_bind_group(device.context(), layout, bindings, list, label));
  BindGroup group;
  group.object_ = Object(ObjectKind::BindGroup, id);
  return group;
}

namespace {

Result<CompiledPipeline> compile(Device& device, const ShaderSource& source, const std::string& path,
                                 std::span<const Constant> constants) {
  backend::Context& context = device.context();
  WEFT_TRY(laid, lay_out(context, source, path, false));
  CompiledPipeline& made = laid.made;
  made.reads_step = std::any_of(made.bindings.begin(), made.bindings.end(), [](const BindingLayout& binding) {
    return binding.kind == BindingKind::StepUniform;
  });
  const std::size_t slash = path.rfind('/') + 1;  // 0 where there is none
  const std::string entry = path.substr(slash, path.rfind('.') - slash);
  WEFT_TRY(pipeline, backend::create_compute_pipeline(context, made.layout.id(), laid.module.id(), entry,
                                                      constants, path));
  made.pipeline = Object(ObjectKind::ComputePipeline, pipeline);
  return std::move(made);
}

/// How many workgroups an adapter that is the processor takes at a time.
std::uint64_t processor_threads() {
#ifdef __EMSCRIPTEN__
  return 4;  // a page does not know
#else
  static const std::uint64_t threads = std::max(1U, std::thread::hardware_concurrency());
  return threads;
#endif
}

}  // namespace

Result<Kernel> Kernel::create(Device& device, const std::string& path, std::vector<Constant> constants,
                              std::uint32_t workgroup_size) {
  if (workgroup_size > device.limits().max_invocations_per_workgroup)
    return make_error(ErrorKind::Limit,
                      "Kernel %s has workgroups of %u, more than this adapter's limit of %u.", path.c_str(),
                      workgroup_size, device.limits().max_invocations_per_workgroup);
  WEFT_TRY(source, ShaderSource::load(path));
  if (source.text.find("override kWorkgroupSize") != std::string::npos)
    constants.push_back({"kWorkgroupSize", static_cast<double>(workgroup_size)});
  Kernel kernel;
  kernel.device_ = &device;
  kernel.label_ = path;
  kernel.workgroup_size_ = workgroup_size;
  WEFT_SET(kernel.compiled_, compiled_once(device.kernels(), pipeline_key(source.text, path, constants),
                                           [&] { return compile(device, source, path, constants); }));
  return kernel;
}

Result<BindGroup> Kernel::bind(std::span<const Binding> sources) const {
  return BindGroup::create(*device_, compiled_->group_layout.id(), compiled_->bindings, sources, label_);
}

void Kernel::dispatch(ComputePass& pass, const BindGroup& group, std::uint64_t count) const {
  dispatch_groups(pass, group, workgroups_of(count));
}

Workgroups Kernel::workgroups_of(std::uint64_t count) const {
  const std::uint64_t groups = (count + workgroup_size_ - 1) / workgroup_size_;
  if (groups <= device_->limits().max_workgroups_per_dimension) return {static_cast<std::uint32_t>(groups)};
  const std::uint64_t rows = (groups + kGroupsPerRow - 1) / kGroupsPerRow;
  assert(rows <= device_->limits().max_workgroups_per_dimension);
  return {kGroupsPerRow, static_cast<std::uint32_t>(rows)};
}

void Kernel::dispatch_strided(ComputePass& pass, const BindGroup& group, std::uint64_t capacity) const {
  dispatch_groups(pass, group, strided(capacity));
}

Workgroups Kernel::strided(std::uint64_t capacity) const {
  // A software adapter executes all of a kernel's code for a workgroup that finds nothing to do.
  const std::uint64_t most =
      device_->adapter().type == "CPU" ? processor_threads() : 262144 / workgroup_size_;
  const std::uint64_t groups = (capacity + workgroup_size_ - 1) / workgroup_size_;
  return {static_cast<std::uint32_t>(std::clamp<std::uint64_t>(groups, 1, most))};
}

void Kernel::dispatch_groups(ComputePass& pass, const BindGroup& group, const Workgroups& workgroups) const {
  pass.dispatch(compiled_->pipeline.id(), group.id(), label_, {workgroups.x, workgroups.y, workgroups.z},
                compiled_->reads_step);
}

}  // namespace weft::gpu
