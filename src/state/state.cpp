#include "state/state.hpp"

#include <algorithm>

#include "model/fabric.hpp"
#include "scene/grab.hpp"

namespace weft {
namespace {

std::vector<Vec4f> start_positions(const Model& model) {
  std::vector<Vec4f> positions(model.vertex_count());
  for (std::size_t i = 0; i < positions.size(); ++i)
    positions[i] =
        Vec4f::from(model.start_position[i].to<float>(), static_cast<float>(model.inverse_mass(i)));
  return positions;
}

}  // namespace

Result<State> State::create(gpu::Device& device, const Model& model, std::uint32_t substeps,
                            std::size_t moving_goals) {
  State state;
  const std::size_t count = model.vertex_count();
  for (std::size_t parity = 0; parity < 2; ++parity) {
    const std::string suffix = parity == 0 ? " a" : " b";
    WEFT_TRY(position, gpu::Buffer<Vec4f>::create(device, count, "position" + suffix, gpu::kVertexStorage));
    WEFT_TRY(velocity, gpu::Buffer<Vec4f>::create(device, count, "velocity" + suffix, gpu::kVertexStorage));
    state.position[parity] = std::move(position);
    state.velocity[parity] = std::move(velocity);
  }
  WEFT_TRY(steps,
           gpu::Buffer<StepBlock>::create(device, substeps, "steps", gpu::kUniform | gpu::kCopyTarget));
  state.steps = std::move(steps);
  state.first_goal = static_cast<std::uint32_t>(3 * model.motions.size() * substeps);
  state.still_goals = static_cast<std::uint32_t>(std::min(count, scene::kMaxGrabs));
  const std::size_t goals = state.still_goals + moving_goals * substeps;
  WEFT_SET(state.motions, gpu::Buffer<Vec4f>::create(device, state.first_goal + goals, "motions"));
  WEFT_TRY(statistics, gpu::Buffer<std::uint32_t>::create(device, sizeof(Statistics) / 4, "statistics"));
  state.statistics = std::move(statistics);
  WEFT_SET(state.creases, gpu::Buffer<Vec4f>::create(device, crease_count(model), "creases"));
  state.reset(device, model);
  return state;
}

void State::reset(gpu::Device& device, const Model& model) const {
  const std::vector<Vec4f> positions = start_positions(model);
  const std::vector<Vec4f> zeros(model.vertex_count());
  for (std::size_t parity = 0; parity < 2; ++parity) {
    position[parity].write(device, positions);
    velocity[parity].write(device, zeros);
  }
  creases.write(device, std::vector<Vec4f>(creases.size()));
}

Result<Contacts> Contacts::create_pushes(gpu::Device& device, const Model& model) {
  Contacts contacts;
  WEFT_TRY(pushes, gpu::Buffer<std::int32_t>::create(device, 4 * model.vertex_count(), "pushes"));
  contacts.pushes = std::move(pushes);
  return contacts;
}

Result<Contacts> Contacts::create_pairs(gpu::Device& device, const Model& model, const ContactRoom& room,
                                        const SolvedContact& solved) {
  Contacts contacts;
  WEFT_TRY(pairs, ContactPairs::create(device, model, room, solved));
  contacts.pairs = std::move(pairs);
  return contacts;
}

}  // namespace weft
