#include "solver/mass_spring/stability.hpp"

#include <algorithm>

#include "base/random.hpp"
#include "gpu/readback.hpp"

namespace weft {
namespace {


/// x <- A x / |A x| for the stiffness or the damping of one network.
class PowerIteration {
 public:
  static Result<PowerIteration> create(gpu::Device& device, const SpringNetwork& network, bool damping) {
    PowerIteration made;
    const auto count = static_cast<std::uint32_t>(network.position.size());
    made.count_ = count;
    const Neighbours built = build_neighbours(network.springs, 0, count);
    Random random(1);
    std::vector<Vec4f> start(count);
    for (Vec4f& x : start)
      x = {static_cast<float>(random.uniform(-1, 1)), static_cast<float>(random.uniform(-1, 1)),
           static_cast<float>(random.uniform(-1, 1)), 0};
    const PowerParams params{count, damping ? 1U : 0U};
    WEFT_TRY(uniform, gpu::Buffer<PowerParams>::create_from(device, std::span(&params, 1), "power params",
                                                            gpu::kUniform | gpu::kCopyTarget));
    WEFT_TRY(offsets, gpu::Buffer<std::uint32_t>::create_from(device, built.offsets, "network offsets"));
    WEFT_TRY(neighbours, gpu::Buffer<Neighbour>::create_from(device, built.entries, "network"));
    WEFT_TRY(position, gpu::Buffer<Vec4f>::create_from(device, network.position, "network position"));
    WEFT_TRY(x, gpu::Buffer<Vec4f>::create_from(device, start, "power x"));
    WEFT_TRY(y, gpu::Buffer<Vec4f>::create(device, count, "power y"));
    WEFT_TRY(partial,
             gpu::Buffer<float>::create(device, (count + kNormBlock - 1) / kNormBlock, "power partial sums"));
    WEFT_TRY(norm, gpu::Buffer<float>::create(device, 1, "power norm"));
    WEFT_TRY(apply, gpu::Kernel::create(device, "mass_spring/apply_network.wgsl"));
    WEFT_TRY(sum_squares, gpu::Kernel::create(device, "mass_spring/sum_squares.wgsl", {}, kNormBlock));
    WEFT_TRY(finish_norm, gpu::Kernel::create(device, "mass_spring/finish_norm.wgsl", {}, kNormBlock));
    WEFT_TRY(scale, gpu::Kernel::create(device, "mass_spring/scale_by_norm.wgsl"));
    WEFT_TRY(apply_group, apply.bind({uniform, offsets, neighbours, position, x, y}));
    WEFT_TRY(sum_group, sum_squares.bind({y, partial}));
    WEFT_TRY(finish_group, finish_norm.bind({partial, norm}));
    WEFT_TRY(scale_group, scale.bind({y, norm, x}));
    made.uniform_ = std::move(uniform), made.offsets_ = std::move(offsets),
    made.neighbours_ = std::move(neighbours);
    made.position_ = std::move(position), made.x_ = std::move(x), made.y_ = std::move(y);
    made.partial_ = std::move(partial), made.norm_ = std::move(norm);
    made.apply_ = std::move(apply), made.sum_squares_ = std::move(sum_squares);
    made.finish_norm_ = std::move(finish_norm), made.scale_ = std::move(scale);
    made.apply_group_ = std::move(apply_group), made.sum_group_ = std::move(sum_group);
    made.finish_group_ = std::move(finish_group), made.scale_group_ = std::move(scale_group);
    return made;
  }

  /// The largest eigenvalue, from below.
  Result<double> run(gpu::Device& device, std::uint32_t iterations) const {
    gpu::CommandList list;
    {
      gpu::ComputePass pass(list, "power iteration");
      for (std::uint32_t i = 0; i < iterations; ++i) {
        apply_.dispatch(pass, apply_group_, count_);
        sum_squares_.dispatch(pass, sum_group_, count_);
        finish_norm_.dispatch_groups(pass, finish_group_, 1);
        scale_.dispatch(pass, scale_group_, count_);
      }
    }
    WEFT_CHECK(device.submit(list));
    WEFT_TRY(norm, gpu::download(device, norm_));
    return static_cast<double>(norm[0]);
  }

 private:
  gpu::RawBuffer uniform_, offsets_, neighbours_, position_, x_, y_, partial_;
  gpu::Buffer<float> norm_;
  gpu::Kernel apply_, sum_squares_, finish_norm_, scale_;
  gpu::BindGroup apply_group_, sum_group_, finish_group_, scale_group_;
  std::uint32_t count_ = 0;
};

}  // namespace

Result<NetworkSpectrum> find_spectrum(gpu::Device& device, const SpringNetwork& network,
                                      std::uint32_t iterations) {
  NetworkSpectrum spectrum;
  const auto any_damping = std::any_of(network.springs.begin(), network.springs.end(),
                                       [](const Spring& spring) { return spring.damping > 0; });
  for (const bool damping : {false, true}) {
    if (damping && !any_damping) continue;
    WEFT_TRY(power, PowerIteration::create(device, network, damping));
    WEFT_TRY(value, power.run(device, iterations));
    (damping ? spectrum.damping : spectrum.stiffness) = value;
  }
  return spectrum;
}

Result<StepLimit> mass_spring_step_limit(gpu::Device& device, const HostModel& model, double drag) {
  std::vector<NetworkSpectrum> cloths;
  for (const ClothModel& cloth : model.cloths) {
    WEFT_TRY(spectrum, find_spectrum(device, stiffest_part(model, cloth)));
    cloths.push_back(spectrum);
  }
  return least_step_limit(std::move(cloths), drag);
}

}  // namespace weft
