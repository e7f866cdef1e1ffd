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

/// What an accessor is for. Joints are numbers of a skin's joints, four a vertex, Weights what each of them counts;
/// Matrices are of 16 numbers, column by column; Times, Vectors and Rotations are of animations.
enum class GltfKind { Positions, Indices, Joints, Weights, Matrices, Times, Vectors, Rotations };

class GltfAccessor {
 public:
  /// Finds accessor `index`, which `who` names, and checks that all of it lies in the file's binary chunk.
  /// Errors  Input: what is wrong, with its path; sparse or compressed data, other files, other types than the
  ///         specification has for the kind (of positions, vectors, times and matrices: floats).
  static Result<GltfAccessor> find(const GlbChunks& glb, std::uint64_t index, const std::string& who,
                                   GltfKind kind);

  std::uint64_t count() const { return count_; }
  Vec3f position(std::uint64_t i) const;
  std::uint32_t index(std::uint64_t i, std::uint32_t component = 0) const;
  /// A float, or an integer as the part of its largest value that it stands for.
  double value(std::uint64_t i, std::uint32_t component) const;

 private:
  GltfAccessor(std::span<const std::byte> bytes, std::uint64_t count, std::uint64_t stride,
               std::uint64_t component_type, unsigned size)
      : bytes_(bytes), count_(count), stride_(stride), component_type_(component_type), size_(size) {}
  std::uint32_t load(std::uint64_t at) const;

  std::span<const std::byte> bytes_;  // from the first element
  std::uint64_t count_;
  std::uint64_t stride_;  // bytes, from one element to the next
  std::uint64_t component_type_;
  unsigned size_;  // bytes of a component
};

}  // namespace weft::mesh
