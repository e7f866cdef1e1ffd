#include "contact/proximity/respond.hpp"

namespace weft::contact {
namespace {

constexpr std::size_t kRoundsOfEnds =
    2;  // in which ways along patches are measured: later ones find few more
constexpr std::uint32_t kCalmFrames = 30;  // after which pressed cloth's iterations are no longer recorded

}  // namespace

Result<Respond> Respond::create(gpu::Device& device, const Setup& setup) {
  Respond made;
  made.setup_ = setup;
  made.recorded_ = setup.impulses.iterations;
  made.separation_count_ = setup.self || !setup.edges.empty() ? setup.separations : 0;
  struct Wanted {
    gpu::Kernel& kernel;
    const char* path;
    std::vector<gpu::Constant> constants = {};
  };
  const gpu::Constant presses{"kPresses", setup.presses ? 1.0 : 0.0},
      move{"kMove", setup.balances ? 0.0 : 1.0}, heavy{"kHeavy", setup.impulses.heavy ? 1.0 : 0.0},
      rigid{"kRigid", setup.rigid ? 1.0 : 0.0}, keeps_lost{"kKeepsLost", setup.yielding.empty() ? 0.0 : 1.0};
  std::vector<Wanted> all = {
      {made.last_impulse_,
       "contact/proximity/contact_impulse.wgsl",
       {presses,
        heavy,
        rigid,
        {"kOwnPushTime", setup.push_times.of_one_cloth},
        {"kBodyPushTime", setup.push_times.of_bodies}}},
      {made.respond_,
       "contact/proximity/contact_respond.wgsl",
       {move, rigid, keeps_lost, {"kDetectInterval", static_cast<double>(setup.interval)}}}};
  const gpu::Constant where_pressed{"kWherePressed", made.has_pressed() ? 1.0 : 0.0};
  if (made.has_pressed()) {
    std::vector<gpu::Constant> asks = all.back().constants;
    asks.push_back({"kAllIterations", 0});
    all.push_back({made.ask_respond_, "contact/proximity/contact_respond.wgsl", std::move(asks)});
  }
  if (setup.impulses.heavy)
    all.push_back({made.first_impulse_,
                   "contact/proximity/contact_impulse.wgsl",
                   {presses, heavy, rigid, {"kFirst", 1}, {"kLast", 0}}});
  if (setup.impulses.pressed > 1) {
    all.push_back({made.impulse_,
                   "contact/proximity/contact_impulse.wgsl",
                   {presses, heavy, rigid, where_pressed, {"kLast", 0}}});
    all.push_back({made.add_, "contact/proximity/add_impulses.wgsl", {move, where_pressed}});
  }
  for (const Wanted& wanted : all) {
    WEFT_TRY(kernel, gpu::Kernel::create(device, wanted.path, wanted.constants, setup.workgroup_size));
    wanted.kernel = std::move(kernel);
  }
  const auto in_rounds = [&](const char* path, const std::vector<Round>& rounds,
                             std::vector<gpu::Constant> constants = {}) {
    return RoundKernel::create(device, path, std::move(constants), rounds, setup.workgroup_size);
  };
  const std::vector<Round> separations = separation_rounds(made.separation_count_);
  const std::vector<Round> holds = holding_rounds(setup.self);
  made.holding_count_ = holds.size();
  WEFT_SET(made.moves_, in_rounds("contact/proximity/separate_ways.wgsl", separations));
  WEFT_SET(made.find_meeting_, in_rounds("contact/proximity/find_meeting.wgsl", holds));
  WEFT_SET(made.hold_back_, in_rounds("contact/proximity/hold_back.wgsl", holds, {keeps_lost}));
  if (setup.self)
    WEFT_SET(made.separate_, SeparationRounds::create(device, "contact/proximity/separate_pairs.wgsl",
                                                      made.separation_count_, setup.workgroup_size));
  WEFT_SET(made.edges_,
           EdgeLimits::create(device, setup.edges, made.separation_count_, setup.workgroup_size));
  WEFT_SET(made.held_edges_,
           HeldEdges::create(device, setup.yielding, setup.yielding_time, setup.workgroup_size));
  made.setup_.edges = {};  // the caller's
  made.setup_.yielding = {};
  return made;
}

Result<void> Respond::bind(gpu::Device& device, const State& state, const ContactPairs& pairs,
                           const gpu::Buffer<Vec4f>& points, const gpu::Buffer<std::uint32_t>& rigid) {
  // A kernel binds buffers that it does not read.
  const gpu::RawBuffer& presses =
      setup_.presses ? static_cast<const gpu::RawBuffer&>(pairs.presses) : pairs.kept;
  begun_ = {};
  if (setup_.impulses.heavy)
    WEFT_SET(begun_, gpu::Buffer<Vec4f>::create(device, pairs.room.near, "forces before they went ahead"));
  const gpu::RawBuffer& begun =
      setup_.impulses.heavy ? static_cast<const gpu::RawBuffer&>(begun_) : pairs.listed;
  for (std::size_t parity = 0; parity < 2; ++parity) {
    const auto& start = state.position[parity];
    const auto &position = state.position[1 - parity], &velocity = state.velocity[1 - parity];
    const auto bind_impulse = [&](const gpu::Kernel& kernel) {
      return kernel.bind({state.steps, start, pairs.predicted, pairs.contacts, pairs.vertex_contacts,
                          state.statistics, presses, begun, rigid});
    };
    WEFT_SET(last_impulse_groups_[parity], bind_impulse(last_impulse_));
    if (setup_.impulses.heavy) WEFT_SET(first_impulse_groups_[parity], bind_impulse(first_impulse_));
    const auto bind_respond = [&](const gpu::Kernel& kernel) {
      return kernel.bind({state.steps, start, pairs.predicted, pairs.contacts, pairs.vertex_contacts,
                          position, velocity, state.statistics, rigid});
    };
    WEFT_SET(respond_groups_[parity], bind_respond(respond_));
    if (has_pressed()) WEFT_SET(ask_respond_groups_[parity], bind_respond(ask_respond_));
    if (setup_.impulses.pressed > 1) {
      WEFT_SET(impulse_groups_[parity], bind_impulse(impulse_));
      WEFT_SET(add_groups_[parity],
               add_.bind({state.steps, pairs.predicted, pairs.vertex_contacts, position, state.statistics}));
    }
    if (setup_.self)
      WEFT_CHECK(separate_.bind(parity, {state.steps, start, position, velocity, points, pairs.listed,
                                         pairs.contacts, pairs.vertex_contacts, state.statistics}));
    WEFT_CHECK(moves_.bind(parity, {state.steps, start, pairs.predicted, pairs.contacts,
                                    pairs.vertex_contacts, position, velocity, state.statistics}));
    WEFT_CHECK(find_meeting_.bind(parity, {state.steps, start, position, points, pairs.listed, pairs.contacts,
                                           pairs.vertex_contacts, state.statistics}));
    WEFT_CHECK(hold_back_.bind(parity, {state.steps, start, pairs.contacts, pairs.vertex_contacts, position,
                                        velocity, state.statistics, state.velocity[parity]}));
  }
  pair_room_ = pairs.room.pairs;
  near_room_ = pairs.room.near;
  vertex_count_ = state.position[0].size();
  WEFT_CHECK(held_edges_.bind(state, pairs));
  return edges_.bind(state, pairs);
}

bool Respond::adapt(const Statistics& report) {
  const std::uint32_t before = recorded_;
  if (report.pressing != 0) {
    recorded_ = setup_.impulses.pressed;
    calm_ = 0;
  } else if (++calm_ >= kCalmFrames) {
    recorded_ = setup_.impulses.iterations;
  }
  return recorded_ != before;
}

void Respond::record_impulses(gpu::ComputePass& pass, const RigidBodies& rigid) const {
  const std::uint32_t parity = pass.parity();
  for (std::uint32_t iteration = 1; iteration < recorded_; ++iteration) {
    if (setup_.impulses.heavy && iteration == 1) {
      first_impulse_.dispatch_strided(pass, first_impulse_groups_[parity], near_room_);
    } else {
      impulse_.dispatch_strided(pass, impulse_groups_[parity], near_room_);
    }
    add_.dispatch(pass, add_groups_[parity], vertex_count_);
    rigid.record_gather(pass);
  }
  last_impulse_.dispatch_strided(pass, last_impulse_groups_[parity], near_room_);
}

void Respond::record_hold_back(gpu::ComputePass& pass, const ClothPatches& patches) const {
  const std::uint32_t parity = pass.parity();
  if (recorded_ < setup_.impulses.pressed) {
    ask_respond_.dispatch(pass, ask_respond_groups_[parity], vertex_count_);
  } else {
    respond_.dispatch(pass, respond_groups_[parity], vertex_count_);
  }
  for (std::size_t round = 0; round < separation_count_; ++round) {
    if (setup_.self) separate_.count.dispatch_strided(pass, round, pair_room_);
    edges_.record_counts(pass, round);
    patches.record_counts(pass, round);
    if (setup_.self) separate_.give.dispatch_strided(pass, round, pair_room_);
    edges_.record_gifts(pass, round);
    patches.record_gifts(pass, round);
    moves_.dispatch(pass, round, vertex_count_);
  }
  for (std::size_t round = 0; round < holding_count_; ++round) {
    patches.record_marks(pass, round);
    find_meeting_.dispatch_strided(pass, round, pair_room_);
    if (round < kRoundsOfEnds) patches.record_ends(pass, round);
    hold_back_.dispatch(pass, round, vertex_count_);
    if (round == 0) held_edges_.record(pass);
  }
}

}  // namespace weft::contact
