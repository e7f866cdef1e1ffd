#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "gpu/types.hpp"

namespace weft::gpu {

struct EmbeddedShader {
  const char* path;  // below src/
  const char* text;
};

/// All shaders of src/, as it was when weft was built; sorted by path.
std::span<const EmbeddedShader> embedded_shaders();

/// A WGSL text with its includes put in, and what it binds.
struct ShaderSource {
  std::string text;
  std::vector<BindingLayout> bindings;  // of group 0, in the order of their numbers

  /// Reads src/`path` and what it includes, each file once. Where WEFT_SHADERS names a folder, files are
  /// read from there, so that a kernel can be changed without a build. Errors  Shader: a file is missing, or
  /// a binding is not of a kind that weft knows.
  static Result<ShaderSource> load(const std::string& path);
};

/// The @group(0) bindings that a WGSL text declares, one a line.
Result<std::vector<BindingLayout>> parse_bindings(const std::string& text);

}  // namespace weft::gpu
