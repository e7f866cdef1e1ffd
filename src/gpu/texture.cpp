#include "gpu/texture.hpp"

#include <algorithm>

namespace weft::gpu {

Result<Texture> Texture::create(Device& device, const TextureInfo& info, const std::string& label) {
  const std::uint32_t side = std::max(info.width, info.height);
  if (side > device.limits().max_texture_size)
    return make_error(ErrorKind::Limit, "Texture %s is %u pixels long, more than this adapter's limit of %u.",
                      label.c_str(), side, device.limits().max_texture_size);
  Texture texture;
  texture.info_ = info;
  WEFT_TRY(id, backend::create_texture(device.context(), info, label));
  texture.texture_ = Object(ObjectKind::Texture, id);
  WEFT_TRY(view, backend::create_texture_view(device.context(), id, label));
  texture.view_ = Object(ObjectKind::TextureView, view);
  return texture;
}

Result<Sampler> Sampler::create(Device& device, const SamplerInfo& info, const std::string& label) {
  WEFT_TRY(id, backend::create_sampler(device.context(), info, label));
  Sampler sampler;
  sampler.object_ = Object(ObjectKind::Sampler, id);
  return sampler;
}

}  // namespace weft::gpu
