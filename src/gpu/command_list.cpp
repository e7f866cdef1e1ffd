#include "gpu/command_list.hpp"

#include <algorithm>
#include <cassert>

namespace weft::gpu {

void CommandList::copy(const BindingSource& source, const BindingSource& target) {
  assert(source.size == target.size);
  commands_.push_back(
      {CommandKind::CopyBuffer, {source.id, target.id}, {}, {source.offset, target.offset, source.size}});
}

void CommandList::clear(const BindingSource& buffer) {
  commands_.push_back({CommandKind::ClearBuffer, {buffer.id}, {}, {buffer.offset, buffer.size}});
}

void CommandList::copy_texture(Id texture, Id buffer, std::uint32_t width, std::uint32_t height,
                               std::uint32_t row_bytes) {
  commands_.push_back({CommandKind::CopyTexture, {texture, buffer}, {width, height, row_bytes}, {}});
}

void CommandList::resolve_queries(Id query_set, std::uint32_t count, Id buffer) {
  commands_.push_back({CommandKind::ResolveQueries, {query_set, buffer}, {count}, {}});
}

void CommandList::reset() {
  commands_.clear();
  targets_.clear();
  labels_.clear();
  phases_.clear();
}

const std::string& CommandList::phase_of(std::size_t command) const {
  static const std::string none;
  const auto after = std::upper_bound(phases_.begin(), phases_.end(), command,
                                      [](std::size_t at, const Phase& phase) { return at < phase.first; });
  return after == phases_.begin() ? none : labels_[std::prev(after)->label];
}

std::size_t CommandList::phase_count(const std::string& name) const {
  return static_cast<std::size_t>(std::count_if(
      phases_.begin(), phases_.end(), [&](const Phase& phase) { return labels_[phase.label] == name; }));
}

std::size_t CommandList::dispatch_count() const {
  return static_cast<std::size_t>(
      std::count_if(commands_.begin(), commands_.end(),
                    [](const Command& command) { return command.kind == CommandKind::Dispatch; }));
}

std::uint32_t CommandList::add_label(const std::string& label) {
  const auto at = std::find(labels_.begin(), labels_.end(), label);
  const auto index = static_cast<std::uint32_t>(at - labels_.begin());
  if (at == labels_.end()) labels_.push_back(label);
  return index;
}

ComputePass::ComputePass(CommandList& list, const std::string& label, PassTimestamps timestamps)
    : list_(list) {
  list_.commands_.push_back({CommandKind::BeginCompute,
                             {timestamps.query_set},
                             {list_.add_label(label), timestamps.begin, timestamps.end},
                             {}});
}

ComputePass::~ComputePass() { list_.commands_.push_back({CommandKind::EndCompute, {}, {}, {}}); }

void ComputePass::dispatch(Id pipeline, Id bind_group, const std::string& label,
                           std::array<std::uint32_t, 3> groups, bool reads_step) {
  if (groups[0] == 0 || groups[1] == 0 || groups[2] == 0) return;
  list_.commands_.push_back({CommandKind::Dispatch,
                             {pipeline, bind_group},
                             {groups[0], groups[1], groups[2], step_ * kStepStride, reads_step ? 1U : 0U},
                             {list_.add_label(label)}});
}

void ComputePass::repeat(const CommandList& from, const Command& dispatch) {
  Command command = dispatch;
  command.sizes[0] = list_.add_label(from.label(static_cast<std::uint32_t>(dispatch.sizes[0])));
  list_.commands_.push_back(command);
}

void ComputePass::begin_phase(const std::string& name) {
  list_.phases_.push_back({list_.add_label(name), list_.commands_.size()});
}

RenderPass::RenderPass(CommandList& list, const RenderTarget& target, const std::string& label)
    : list_(list) {
  list_.targets_.push_back(target);
  const auto index = static_cast<std::uint32_t>(list_.targets_.size() - 1);
  list_.commands_.push_back({CommandKind::BeginRender, {}, {index, list_.add_label(label)}, {}});
}

RenderPass::~RenderPass() { list_.commands_.push_back({CommandKind::EndRender, {}, {}, {}}); }

void RenderPass::draw(Id pipeline, Id bind_group, std::uint32_t vertices, std::uint32_t instances,
                      std::uint32_t first) {
  if (vertices == 0) return;
  list_.commands_.push_back({CommandKind::Draw, {pipeline, bind_group, 0}, {vertices, instances, first}, {}});
}

void RenderPass::draw_indexed(Id pipeline, Id bind_group, Id index_buffer, std::uint32_t indices,
                              std::uint32_t first) {
  if (indices == 0) return;
  list_.commands_.push_back(
      {CommandKind::Draw, {pipeline, bind_group, index_buffer}, {indices, 1, first}, {}});
}

}  // namespace weft::gpu
