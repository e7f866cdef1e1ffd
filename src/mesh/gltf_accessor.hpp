// The numbers that a glTF accessor stands for, in the bytes of the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "base/result.hpp"
#include "base/vec.hpp"
#include "mesh/glb_chunks.hpp"

namespace weft::mesh {

enum class GltfKind { Positions, Indices };  // what a primitive's accessor is for

class GltfAccessor {
 public:
  /// Finds accessor `index`, which `who` names, and checks that all of it lies in the file's binary chunk.
  /// Errors  Input: what is wrong, with its path; sparse or compressed data, other files, other types than
  ///         three floats or one unsigned integer.
  static Result<GltfAccessor> find(const GlbChunks& glb, std::uint64_t index, const std::string& who,
                                   GltfKind kind);

  std::uint64_t count() const { return count_; }
  Vec3f position(std::uint64_t i) const;
  std::uint32_t index(std::uint64_t i) const;

 private:
  GltfAccessor(std::span<const std::byte> bytes, std::uint64_t count, std::uint64_t stride, unsigned size)
      : bytes_(bytes), count_(count), stride_(stride), size_(size) {}
  std::uint32_t load(std::uint64_t at) const;

  std::span<const std::byte> bytes_;  // from the first element
  std::uint64_t count_;
  std::uint64_t stride_;  // bytes, from one element to the next
  unsigned size_;         // bytes of a component
};

}  // namespace weft::mesh
