// A World beside the caller's own use of the GPU. The handles are the back end's, so nothing needs its header here.
#include "weft/native.hpp"

#include "api/running_world.hpp"
#include "gpu/given_texture.hpp"

namespace weft {

NativeDevice World::native_device() const {
  const gpu::DeviceHandles handles = running_->session.device().handles();
  return {reinterpret_cast<WGPUAdapter>(handles.adapter), reinterpret_cast<WGPUDevice>(handles.device)};
}

NativeBuffer World::native_triangles() const {
  const gpu::Buffer<std::uint32_t>& triangles = running_->world().model().triangles;
  return {reinterpret_cast<WGPUBuffer>(triangles.id()), 0, sizeof(Triangle), triangles.size() / 3};
}

Result<void> World::draw_into(const NativeTarget& target, const ViewOptions& options) {
  sim::World& world = running_->world();
  WEFT_TRY(texture, gpu::GivenTexture::create(world.device(), reinterpret_cast<gpu::Id>(target.texture)));
  const gpu::TextureInfo& info = texture.info();
  PictureOptions picture;
  picture.width = info.width;
  picture.height = info.height;
  picture.view = options.view;
  WEFT_TRY(settings, running_->settings(picture));
  std::optional<view::CanvasView>& drawing = running_->texture_view;
  if (!drawing || drawing->canvas().format != info.format) {
    drawing.reset();
    const view::Canvas canvas{texture.view(), info.format, info.width, info.height};
    WEFT_TRY(made, view::CanvasView::create(world, canvas, settings.view));
    drawing = std::move(made);
  } else {
    if (drawing->canvas().width != info.width || drawing->canvas().height != info.height)
      WEFT_CHECK(drawing->resize(info.width, info.height));
    if (drawing->view() != settings.view) WEFT_CHECK(drawing->set_view(settings.view));
    drawing->set_target(texture.view());
  }
  WEFT_CHECK(running_->count_contacts());
  drawing->set_camera(options.camera.value_or(render::camera_of(settings)));
  drawing->set_time(world.time());
  return world.device().submit(drawing->list(world.parity()));
}

}  // namespace weft
