// Commands for the GPU as flat data: recorded once, replayed for every submit without allocation.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "gpu/types.hpp"

namespace weft::gpu {

enum class CommandKind : std::uint8_t {
  BeginCompute,  // args[0]: label; args[1], args[2]: begin and end timestamp, or kNoTimestamp; ids[0]: query
                 // set
  EndCompute,
  Dispatch,        // ids: pipeline, bind group; args: x, y, z, offset of the step's uniform block, has such a
                   // block; sizes[0]: label, the kernel's
  CopyBuffer,      // ids: source, target; sizes: source offset, target offset, bytes
  ClearBuffer,     // ids: buffer; sizes: offset, bytes
  ResolveQueries,  // ids: query set, buffer; args: count
  BeginRender,     // args[0]: index of the render target, args[1]: label
  EndRender,
  Draw,         // ids: pipeline, bind group, index buffer or 0; args: count, instances, first
  CopyTexture,  // ids: texture, buffer; args: width, height, bytes a row
};

struct Command {
  CommandKind kind{};
  std::array<Id, 3> ids{};
  std::array<std::uint32_t, 5> args{};
  std::array<std::uint64_t, 3> sizes{};
};

struct RenderTarget {
  Id color = 0, resolve = 0, depth = 0;  // texture views
  std::array<double, 4> clear_color{};
  bool store_depth = false;
};

inline constexpr std::uint32_t kNoTimestamp = 0xffffffffU;

/// A list of passes, copies and clears. Whatever it names must outlive it.
class CommandList {
 public:
  void copy(const BindingSource& source, const BindingSource& target);  ///< whole ranges of equal size
  void clear(const BindingSource& buffer);
  void copy_texture(Id texture, Id buffer, std::uint32_t width, std::uint32_t height,
                    std::uint32_t row_bytes);
  void resolve_queries(Id query_set, std::uint32_t count, Id buffer);
  void reset();

  std::size_t dispatch_count() const;
  /// In which phase a command of commands() was recorded (ComputePass::begin_phase); "" before the first.
  const std::string& phase_of(std::size_t command) const;
  /// How often a phase of this name began.
  std::size_t phase_count(const std::string& name) const;
  const std::vector<Command>& commands() const { return commands_; }
  const std::vector<RenderTarget>& targets() const { return targets_; }
  const std::string& label(std::uint32_t index) const { return labels_[index]; }

 private:
  friend class ComputePass;
  friend class RenderPass;
  std::uint32_t add_label(const std::string& label);
  /// Commands from `first` on, until the next phase begins.
  struct Phase {
    std::uint32_t label = 0;
    std::size_t first = 0;
  };

  std::vector<Command> commands_;
  std::vector<RenderTarget> targets_;
  std::vector<std::string> labels_;
  std::vector<Phase> phases_;
};

/// A query pair that a pass writes its begin and end to.
struct PassTimestamps {
  Id query_set = 0;
  std::uint32_t begin = kNoTimestamp, end = kNoTimestamp;
};

/// Records dispatches into a list, from its making to its end of life.
/// Knows the substep that is being recorded: kernels that read a step's block get that substep's, and
/// wrappers that swap buffers every substep choose theirs by its parity.
class ComputePass {
 public:
  ComputePass(CommandList& list, const std::string& label, PassTimestamps timestamps = {});
  ~ComputePass();
  ComputePass(const ComputePass&) = delete;
  ComputePass& operator=(const ComputePass&) = delete;

  void dispatch(Id pipeline, Id bind_group, const std::string& label, std::array<std::uint32_t, 3> groups,
                bool reads_step = false);

  /// Records a dispatch of another list again, for its own substep.
  void repeat(const CommandList& from, const Command& dispatch);

  /// Names what is recorded from here on, for those who ask what a part of a frame costs.
  void begin_phase(const std::string& name);

  /// `parity` says which of the two state buffers holds the state before this substep.
  void set_step(std::uint32_t step, std::uint32_t parity) { step_ = step, parity_ = parity; }
  std::uint32_t step() const { return step_; }
  std::uint32_t parity() const { return parity_; }

 private:
  CommandList& list_;
  std::uint32_t step_ = 0, parity_ = 0;
};

/// Records draws into a list, from its making to its end of life.
class RenderPass {
 public:
  RenderPass(CommandList& list, const RenderTarget& target, const std::string& label);
  ~RenderPass();
  RenderPass(const RenderPass&) = delete;
  RenderPass& operator=(const RenderPass&) = delete;

  void draw(Id pipeline, Id bind_group, std::uint32_t vertices, std::uint32_t instances = 1,
            std::uint32_t first = 0);
  void draw_indexed(Id pipeline, Id bind_group, Id index_buffer, std::uint32_t indices,
                    std::uint32_t first = 0);

 private:
  CommandList& list_;
};

/// Bytes of a substep's uniform block. A multiple of 256: no device may ask for a coarser offset alignment.
inline constexpr std::uint32_t kStepStride = 512;

}  // namespace weft::gpu
