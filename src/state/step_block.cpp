#include "state/step_block.hpp"

namespace weft {

void set_air(StepBlock::Air& part, const std::optional<scene::Air>& air) {
  const scene::Air given = air.value_or(scene::Air{.density = 0});
  const double half = given.density / 2;
  part.pressure = static_cast<float>(half * given.pressure);
  part.lift = static_cast<float>(half * given.lift);
  part.friction = static_cast<float>(half * given.friction);
}

void set_wind(StepBlock::Air& air, const scene::WindField& wind, const std::array<double, 2>& turns) {
  air.wind = Vec4f::from(wind.velocity.to<float>(), wind.blows() ? 1.0F : 0.0F);
  // The whole turns are taken off in double: f32 would have lost the rest after some minutes.
  const auto form = [&](std::size_t wave) {
    return Vec4f::from(wind.waves[wave].gradient.to<float>(),
                       static_cast<float>(scene::turn_part(turns[wave])));
  };
  air.wind_wave_a = form(0);
  air.wind_wave_b = form(1);
  air.gust_a = Vec4f::from(wind.waves[0].gust.to<float>(), 0);
  air.gust_b = Vec4f::from(wind.waves[1].gust.to<float>(), 0);
}

}  // namespace weft
