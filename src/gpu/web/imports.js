// The functions of imports.hpp, each handed on to Module.gpu (packages/weft/src/gpu_backend.ts).
mergeInto(LibraryManager.library, {
  weft_gpu_open__deps: ["$Asyncify"],
  weft_gpu_open: function(adapter, size, timestamps, error) {
    return Asyncify.handleAsync(() => Module["gpu"].open(adapter, size, timestamps, error));
  },
  weft_gpu_wait__deps: ["$Asyncify"],
  weft_gpu_wait: function() {
    return Asyncify.handleAsync(() => Module["gpu"].wait());
  },
  weft_gpu_close: function() {
    Module["gpu"].close();
  },
  weft_gpu_lose: function() {
    Module["gpu"].lose();
  },
  weft_gpu_limits: function(limits) {
    return Module["gpu"].limits(limits);
  },
  weft_gpu_take_error: function() {
    return Module["gpu"].takeError();
  },
  weft_gpu_text_size: function() {
    return Module["gpu"].text.length;
  },
  weft_gpu_text: function(target) {
    HEAPU8.set(Module["gpu"].text, target);
  },
  weft_gpu_release: function(kind, id) {
    Module["gpu"].release(kind, id);
  },
  weft_gpu_buffer: function(bytes, usage, label) {
    return Module["gpu"].buffer(bytes, usage, label);
  },
  weft_gpu_write: function(buffer, offset, bytes, size) {
    Module["gpu"].write(buffer, offset, bytes, size);
  },
  weft_gpu_shader_module: function(source, label) {
    return Module["gpu"].shaderModule(source, label);
  },
  weft_gpu_bind_group_layout: function(entries, count, render, label) {
    return Module["gpu"].bindGroupLayout(entries, count, render, label);
  },
  weft_gpu_pipeline_layout: function(layout, label) {
    return Module["gpu"].pipelineLayout(layout, label);
  },
  weft_gpu_bind_group: function(layout, entries, count, label) {
    return Module["gpu"].bindGroup(layout, entries, count, label);
  },
  weft_gpu_compute_pipeline: function(layout, module, entry, constants, count, label) {
    return Module["gpu"].computePipeline(layout, module, entry, constants, count, label);
  },
  weft_gpu_render_pipeline: function(layout, module, info, constants, count, label) {
    return Module["gpu"].renderPipeline(layout, module, info, constants, count, label);
  },
  weft_gpu_texture: function(width, height, samples, format, usage, label) {
    return Module["gpu"].texture(width, height, samples, format, usage, label);
  },
  weft_gpu_texture_view: function(texture, label) {
    return Module["gpu"].textureView(texture, label);
  },
  weft_gpu_sampler: function(linear, repeat, comparison, label) {
    return Module["gpu"].sampler(linear, repeat, comparison, label);
  },
  weft_gpu_queries: function(count, label) {
    return Module["gpu"].queries(count, label);
  },
  weft_gpu_submit: function(lists, count) {
    Module["gpu"].submit(lists, count);
  },
  weft_gpu_map: function(buffer, bytes, state) {
    Module["gpu"].map(buffer, bytes, state);
  },
  weft_gpu_take_mapped: function(buffer, target, size) {
    Module["gpu"].takeMapped(buffer, target, size);
  },
});
