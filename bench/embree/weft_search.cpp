#include "weft_search.hpp"

#include <algorithm>
#include <cstddef>
#include <map>

#include "gpu/readback.hpp"

namespace weft {
namespace {

/// The dispatches up to the one that finds candidates.
void record_broad_phase(const contact::PairSearch& search, gpu::CommandList& list) {
  gpu::CommandList whole;
  {
    gpu::ComputePass pass(whole, "search");
    search.record(pass);
  }
  gpu::ComputePass pass(list, "broad phase");
  for (const gpu::Command& command : whole.commands()) {
    if (command.kind != gpu::CommandKind::Dispatch) continue;
    pass.repeat(whole, command);
    if (whole.label(static_cast<std::uint32_t>(command.sizes[0])) == "contact/proximity/find_candidates.wgsl")
      return;
  }
}

}  // namespace

Result<WeftSearch> WeftSearch::create(gpu::Device& device, const SearchCase& search, std::uint32_t room) {
  WeftSearch made;
  made.device_ = &device;
  made.object_ = search.object;
  WEFT_TRY(model, GpuModel::create(device, Model(search.model)));
  made.model_ = std::move(model);
  WEFT_TRY(state, State::create(device, made.model_.host, 1));
  made.state_ = std::move(state);
  WEFT_TRY(pairs, ContactPairs::create(device, made.model_.host, {1024, room}));
  made.pairs_ = std::move(pairs);
  scene::Scene scene;
  scene.cloths.resize(made.model_.host.bodies.size());
  std::vector<mesh::TriangleMesh> objects;
  std::vector<std::size_t> colliders;
  if (!search.self()) {
    scene.colliders.push_back(scene::ColliderMesh{});
    objects.push_back(search.object);
    colliders.push_back(0);
  }
  const std::vector<std::vector<mesh::TriangleMesh>> keyframes(objects.size());
  WEFT_TRY(pair_search,
           contact::PairSearch::create(
               device, made.model_, made.state_, made.pairs_, scene, {objects, colliders, keyframes},
               {search.thickness, search.self() ? search.thickness : 0, search.flat_reach}));
  made.search_ = std::move(pair_search);

  std::vector<Vec4f> places;
  for (const Vec3f& p : search.positions) places.push_back(Vec4f::from(p, 1));
  made.state_.position[0].write(device, places);
  StepBlock step;
  step.time.dt = 1;
  step.nodes.count = made.model_.vertex_count();
  step.contact.least_reach = step.contact.most_reach = search.reach;
  step.contact.detect = Detect::Always;
  made.state_.steps.write(device, std::span(&step, 1));
  record_broad_phase(made.search_, made.list_);
  WEFT_CHECK(device.wait());
  return made;
}

Result<void> WeftSearch::run() const {
  WEFT_CHECK(device_->submit(list_));
  return device_->wait();
}

Result<std::vector<PairKey>> WeftSearch::pairs() const {
  WEFT_TRY(statistics, gpu::download(*device_, state_.statistics));
  if (statistics[offsetof(Statistics, rolled_back) / sizeof(std::uint32_t)] != 0)
    return make_error(ErrorKind::Limit, "There is no room for %u candidates.",
                      statistics[offsetof(Statistics, candidates) / sizeof(std::uint32_t)]);
  WEFT_TRY(candidates, gpu::download(*device_, search_.candidates()));
  candidates.resize(statistics[offsetof(Statistics, candidates) / sizeof(std::uint32_t)]);
  // A candidate names an object's triangle by where its corners stand among the words of the trees.
  const std::size_t cloth_words = contact::ImplicitTree(model_.triangle_count()).words().size();
  std::map<mesh::Triangle, std::uint32_t> numbers;
  for (std::uint32_t t = 0; t < object_.triangles.size(); ++t) numbers[object_.triangles[t]] = t;
  std::vector<PairKey> keys;
  for (const auto& [x, y] : candidates) {
    std::uint32_t other = y;
    if (!object_.triangles.empty()) {
      mesh::Triangle corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = search_.colliders().trees.at(y - cloth_words + k).w & kIdBits;
      other = numbers.at(corners);
    }
    keys.push_back(pair_key(x & 0x0fffffffU, other));
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

}  // namespace weft
