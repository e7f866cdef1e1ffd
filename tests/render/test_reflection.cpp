#include <cmath>

#include "gpu/kernel.hpp"
#include "gpu/readback.hpp"
#include "render/fabric.hpp"
#include "render/sheet.hpp"
#include "scene/looks.hpp"

using namespace weft;
using namespace weft::render;

namespace {

/// What cloth of albedo 1 sends back of a radiance of 1 from everywhere, by yarn and by direction of the eye.
struct Sent {
  float sun, around;
};
std::vector<Sent> sent_by(gpu::Device& device, const std::vector<Vec4f>& samples) {
  const auto buffer = value_of(gpu::Buffer<Vec4f>::create_from(device, samples, "samples"));
  const auto sent = value_of(gpu::Buffer<Sent>::create(device, samples.size() / 2, "sent"));
  const gpu::Kernel kernel = value_of(gpu::Kernel::create(device, "render/test/even_light.wgsl"));
  const gpu::BindGroup group = value_of(kernel.bind({buffer, sent}));
  gpu::CommandList list;
  {
    gpu::ComputePass pass(list, "even light");
    kernel.dispatch(pass, group, sent.size());
  }
  REQUIRE(device.submit(list));
  return value_of(gpu::download(device, sent));
}

}  // namespace

TEST_CASE("cloth that absorbs nothing sends back what arrives, and no more") {
  GpuFixture fixture;
  std::vector<Vec4f> samples;
  for (const scene::NamedLook& look : scene::kLooks)
    for (const bool most : {false, true}) {  // with all sheen and gloss that a scene can ask for
      ClothRange range;
      range.look = scene::look_of(look.name);
      if (most) range.look.sheen = range.look.gloss = 1;
      const FabricParams fabric = fabric_of(range, 0);
      for (const float cosine : {0.05F, 0.15F, 0.4F, 0.7F, 1.0F})
        for (const float turn : {0.0F, 0.8F, 1.571F}) {
          samples.push_back({fabric.stripe.w, fabric.tint.w, fabric.gloss.z, fabric.accent.w});
          samples.push_back({fabric.gloss.x, fabric.gloss.y, cosine, turn});
        }
    }
  const std::vector<Sent> sent = sent_by(fixture.device(), samples);
  REQUIRE(sent.size() == samples.size() / 2);
  for (std::size_t k = 0; k < sent.size(); ++k) {
    CAPTURE(samples[2 * k].x);
    CAPTURE(samples[2 * k].y);
    CAPTURE(samples[2 * k + 1].x);
    CAPTURE(samples[2 * k + 1].z);
    CHECK(sent[k].sun < 1.01);  // 0.008 by which the fit of sheen may be off, and the quadrature's error
    CHECK(sent[k].sun > 0.75);  // energy is lost only where light or eye are at a slant
    CHECK(sent[k].around == doctest::Approx(1).epsilon(1e-5));
  }
}
