// Algorithm 2 on random pushes, against its three lines.
#include <cmath>

#include "contact/pushes/contact_response.hpp"
#include "gpu/gpu_fixture.hpp"
#include "method/solver_rig.hpp"

using namespace weft;

TEST_CASE(
    "a node with contacts goes to its previous place plus the mean push, turns at half speed, and is "
    "cleared") {
  GpuFixture fixture;
  gpu::Device& device = fixture.device();
  Random random(4);
  const std::uint32_t count = 1000;
  Model host;
  host.rest_position.resize(count);
  host.start_position.resize(count);
  host.mass.assign(count, 1.0);
  host.motion.assign(count, 0);
  auto state = State::create(device, host, 1);
  REQUIRE_OK(state);
  auto contacts = Contacts::create_pushes(device, host);
  REQUIRE_OK(contacts);
  const auto draw = [&](double size) { return static_cast<float>(random.uniform(-size, size)); };
  std::vector<Vec4f> previous(count), predicted(count), velocity(count);
  std::vector<std::int32_t> pushes(4UL * count, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    previous[i] = {draw(1), draw(1), draw(1), 2};
    predicted[i] = {draw(1), draw(1), draw(1), 2};
    velocity[i] = {draw(3), draw(3), draw(3), 0};
    if (random.below(3) == 0) continue;
    for (std::uint32_t axis = 0; axis < 3; ++axis)
      pushes[4 * i + axis] = static_cast<std::int32_t>(random.below(2000000)) - 1000000;
    pushes[4 * i + 3] = 1 + static_cast<std::int32_t>(random.below(9));
  }
  StepBlock params;
  params.nodes.count = count;
  params.contact.push_scale = 1U << 20U;
  state->steps.write(device, std::span(&params, 1));
  state->position[0].write(device, previous);
  state->position[1].write(device, predicted);
  state->velocity[1].write(device, velocity);
  contacts->pushes.write(device, pushes);
  auto response = ContactResponse::create(device, *state, *contacts, 256);
  REQUIRE_OK(response);
  gpu::CommandList list;
  {
    gpu::ComputePass pass(list, "response");
    response->record(pass);
  }
  const auto submitted = device.submit(list);
  REQUIRE_OK(submitted);
  const auto position = gpu::download(device, state->position[1]);
  const auto turned = gpu::download(device, state->velocity[1]);
  const auto left = gpu::download(device, contacts->pushes);
  REQUIRE_OK(position);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::int32_t hits = pushes[4 * i + 3];
    for (int axis = 0; axis < 3; ++axis) {
      const float v = velocity[i].xyz()[axis];
      if (hits == 0) {
        CHECK((*position)[i].xyz()[axis] == predicted[i].xyz()[axis]);
        CHECK((*turned)[i].xyz()[axis] == v);
        continue;
      }
      const double mean = pushes[4 * i + static_cast<std::uint32_t>(axis)] / (1048576.0 * hits);
      const double expected = static_cast<double>(previous[i].xyz()[axis]) + mean;
      CHECK(std::abs(static_cast<double>((*position)[i].xyz()[axis]) - expected) <=
            4 * 6e-8);  // |x| < 2, a quotient and a sum
      CHECK((*turned)[i].xyz()[axis] == -0.5F * v);
    }
    CHECK((*position)[i].w == 2.0F);
  }
  for (const std::int32_t push : *left) CHECK(push == 0);
}
