// Encodes command lists and submits them, if and only if they validate: wgpu-native ends the process on a bad submit.
#include <utility>

#include "gpu/native/context.hpp"

namespace weft::gpu::backend {
namespace {

/// Of the first part. A dispatch takes 3 µs to encode, and on a GPU 5 µs or more; so the GPU does not wait for a part
/// that is twice as long as the one before.
constexpr std::uint32_t kFirstPart = 32;

/// Encodes commands and submits them in parts, so that the GPU is at work on one while the next is encoded. Repeated
/// settings of a pass are skipped.
class Encoder {
 public:
  explicit Encoder(Context& context) : context_(context) { open(); }
  ~Encoder() { close(); }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  Result<void> encode(const CommandList& list) {
    list_ = &list;
    for (const Command& command : list.commands()) {
      if (compute_ != nullptr && splits_ && dispatches_ >= part_) WEFT_CHECK(submit_part());
      encode(command);
    }
    return {};
  }
  /// Submits what has been encoded, if that is valid.
  Result<void> submit() {
    WGPUCommandBuffer buffer = watched(context_, [&] { return wgpuCommandEncoderFinish(encoder_, nullptr); });
    const auto error = context_.take_error();
    if (error) watched(context_, [&] { wgpuQueueSubmit(context_.queue, 1, &buffer); });
    if (buffer != nullptr) wgpuCommandBufferRelease(buffer);
    if (!error) return error.error();
    return context_.take_error();
  }

 private:
  void open() { encoder_ = wgpuDeviceCreateCommandEncoder(context_.device, nullptr); }
  void close() {
    if (encoder_ != nullptr) wgpuCommandEncoderRelease(std::exchange(encoder_, nullptr));
  }

  /// Submits what has been encoded, and goes on in the same pass.
  Result<void> submit_part() {
    end_compute();
    WEFT_CHECK(submit());
    close();
    open();
    begin_compute(pass_);
    dispatches_ = 0;
    part_ *= 2;
    return {};
  }

  void encode(const Command& command) {
    switch (command.kind) {
      case CommandKind::BeginCompute:
        return begin_compute(command);
      case CommandKind::Dispatch:
        return dispatch(command);
      case CommandKind::EndCompute:
        return end_compute();
      case CommandKind::CopyBuffer:
        return wgpuCommandEncoderCopyBufferToBuffer(encoder_, handle<WGPUBuffer>(command.ids[0]),
                                                    command.sizes[0], handle<WGPUBuffer>(command.ids[1]),
                                                    command.sizes[1], command.sizes[2]);
      case CommandKind::ClearBuffer:
        return wgpuCommandEncoderClearBuffer(encoder_, handle<WGPUBuffer>(command.ids[0]), command.sizes[0],
                                             command.sizes[1]);
      case CommandKind::ResolveQueries:
        return wgpuCommandEncoderResolveQuerySet(encoder_, handle<WGPUQuerySet>(command.ids[0]), 0,
                                                 command.args[0], handle<WGPUBuffer>(command.ids[1]), 0);
      case CommandKind::BeginRender:
        return begin_render(command);
      case CommandKind::Draw:
        return draw(command);
      case CommandKind::EndRender:
        wgpuRenderPassEncoderEnd(render_);
        return wgpuRenderPassEncoderRelease(std::exchange(render_, nullptr));
      case CommandKind::CopyTexture:
        return copy_texture(command);
    }
  }

  void begin_compute(const Command& command) {
    WGPUPassTimestampWrites writes = WGPU_PASS_TIMESTAMP_WRITES_INIT;
    writes.querySet = handle<WGPUQuerySet>(command.ids[0]);
    writes.beginningOfPassWriteIndex = command.args[1];
    writes.endOfPassWriteIndex = command.args[2];
    WGPUComputePassDescriptor descriptor = WGPU_COMPUTE_PASS_DESCRIPTOR_INIT;
    descriptor.label = view(list_->label(command.args[0]));
    descriptor.timestampWrites = command.ids[0] != 0 ? &writes : nullptr;
    compute_ = wgpuCommandEncoderBeginComputePass(encoder_, &descriptor);
    pipeline_ = 0;
    group_ = 0;
    pass_ = command;
    splits_ = descriptor.timestampWrites == nullptr;
  }
  void end_compute() {
    wgpuComputePassEncoderEnd(compute_);
    wgpuComputePassEncoderRelease(std::exchange(compute_, nullptr));
  }

  void dispatch(const Command& command) {
    if (std::exchange(pipeline_, command.ids[0]) != command.ids[0])
      wgpuComputePassEncoderSetPipeline(compute_, handle<WGPUComputePipeline>(command.ids[0]));
    const bool reads_step = command.args[4] != 0;
    if (std::exchange(group_, command.ids[1]) != command.ids[1] || reads_step)
      wgpuComputePassEncoderSetBindGroup(compute_, 0, handle<WGPUBindGroup>(command.ids[1]),
                                         reads_step ? 1 : 0, &command.args[3]);
    wgpuComputePassEncoderDispatchWorkgroups(compute_, command.args[0], command.args[1], command.args[2]);
    ++dispatches_;
  }

  void begin_render(const Command& command) {
    const RenderTarget& target = list_->targets()[command.args[0]];
    WGPURenderPassColorAttachment color = WGPU_RENDER_PASS_COLOR_ATTACHMENT_INIT;
    color.view = handle<WGPUTextureView>(target.color);
    color.resolveTarget = handle<WGPUTextureView>(target.resolve);
    color.loadOp = WGPULoadOp_Clear;
    color.storeOp = target.resolve != 0 ? WGPUStoreOp_Discard : WGPUStoreOp_Store;
    color.clearValue = {target.clear_color[0], target.clear_color[1], target.clear_color[2],
                        target.clear_color[3]};
    WGPURenderPassDepthStencilAttachment depth = WGPU_RENDER_PASS_DEPTH_STENCIL_ATTACHMENT_INIT;
    depth.view = handle<WGPUTextureView>(target.depth);
    depth.depthLoadOp = WGPULoadOp_Clear;
    depth.depthStoreOp = target.store_depth ? WGPUStoreOp_Store : WGPUStoreOp_Discard;
    depth.depthClearValue = 1.0F;
    WGPURenderPassDescriptor descriptor = WGPU_RENDER_PASS_DESCRIPTOR_INIT;
    descriptor.label = view(list_->label(command.args[1]));
    descriptor.colorAttachments = &color;
    descriptor.colorAttachmentCount = target.color != 0 ? 1 : 0;
    descriptor.depthStencilAttachment = target.depth != 0 ? &depth : nullptr;
    render_ = wgpuCommandEncoderBeginRenderPass(encoder_, &descriptor);
  }

  void draw(const Command& command) {
    wgpuRenderPassEncoderSetPipeline(render_, handle<WGPURenderPipeline>(command.ids[0]));
    wgpuRenderPassEncoderSetBindGroup(render_, 0, handle<WGPUBindGroup>(command.ids[1]), 0, nullptr);
    if (command.ids[2] == 0)
      return wgpuRenderPassEncoderDraw(render_, command.args[0], command.args[1], command.args[2], 0);
    wgpuRenderPassEncoderSetIndexBuffer(render_, handle<WGPUBuffer>(command.ids[2]), WGPUIndexFormat_Uint32,
                                        0, WGPU_WHOLE_SIZE);
    wgpuRenderPassEncoderDrawIndexed(render_, command.args[0], command.args[1], command.args[2], 0, 0);
  }

  void copy_texture(const Command& command) {
    WGPUTexelCopyTextureInfo source = WGPU_TEXEL_COPY_TEXTURE_INFO_INIT;
    source.texture = handle<WGPUTexture>(command.ids[0]);
    WGPUTexelCopyBufferInfo target = WGPU_TEXEL_COPY_BUFFER_INFO_INIT;
    target.buffer = handle<WGPUBuffer>(command.ids[1]);
    target.layout.bytesPerRow = command.args[2];
    target.layout.rowsPerImage = command.args[1];
    const WGPUExtent3D size = {command.args[0], command.args[1], 1};
    wgpuCommandEncoderCopyTextureToBuffer(encoder_, &source, &target, &size);
  }

  Context& context_;
  const CommandList* list_ = nullptr;  // the one that is being encoded
  WGPUCommandEncoder encoder_ = nullptr;
  WGPUComputePassEncoder compute_ = nullptr;
  WGPURenderPassEncoder render_ = nullptr;
  Id pipeline_ = 0, group_ = 0;
  Command pass_;        // the command that began `compute_`
  bool splits_ = true;  // whether it may end and begin again: one with timestamps may not
  std::uint32_t dispatches_ = 0, part_ = kFirstPart;
};

}  // namespace

Result<void> submit(Context& context, std::span<const CommandList* const> lists) {
  WEFT_CHECK(context.take_error());
  const Result<void> submitted = watched(context, [&]() -> Result<void> {
    Encoder encoder(context);
    for (const CommandList* list : lists) WEFT_CHECK(encoder.encode(*list));
    return encoder.submit();
  });
  WEFT_CHECK(submitted);
  return context.take_error();
}

}  // namespace weft::gpu::backend
