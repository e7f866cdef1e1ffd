#include "gpu/shader_source.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <set>

#include "base/file.hpp"

namespace weft::gpu {
namespace {

constexpr std::uint64_t kMaxShaderBytes = 1U << 20U;

Result<std::string> read_shader(const std::string& path) {
  if (const char* folder = std::getenv("WEFT_SHADERS")) {
    WEFT_TRY(bytes, read_file(std::string(folder) + "/" + path, kMaxShaderBytes));
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }
  for (const EmbeddedShader& shader : embedded_shaders())
    if (path == shader.path) return std::string(shader.text);
  return make_error(ErrorKind::Shader, "Shader %s does not exist.", path.c_str());
}

Result<void> append_with_includes(const std::string& path, std::set<std::string>& seen, std::string& text) {
  if (!seen.insert(path).second) return {};
  WEFT_TRY(file, read_shader(path));
  static constexpr char kInclude[] = "#include \"";
  for (std::size_t begin = 0; begin < file.size();) {
    const std::size_t end = std::min(file.find('\n', begin), file.size() - 1);
    const std::string line = file.substr(begin, end - begin + 1);
    begin = end + 1;
    if (line.rfind(kInclude, 0) != 0) {
      text += line;
      continue;
    }
    const std::size_t first = std::strlen(kInclude);
    WEFT_CHECK(append_with_includes(line.substr(first, line.find('"', first) - first), seen, text));
  }
  return {};
}

/// The text between `open` and the next `close` after position `from`, trimmed; empty where there is none.
std::string between(const std::string& line, char open, char close, std::size_t from = 0) {
  const std::size_t begin = line.find(open, from);
  const std::size_t end = begin == std::string::npos ? begin : line.find(close, begin + 1);
  if (end == std::string::npos) return {};
  std::string inner = line.substr(begin + 1, end - begin - 1);
  inner.erase(std::remove(inner.begin(), inner.end(), ' '), inner.end());
  return inner;
}

/// The type of which a dispatch sees the block of its substep: the text names it in a line of its own.
std::string step_type(const std::string& text) {
  static constexpr char kMark[] = "\n// one a step: ";
  const std::size_t mark = text.find(kMark);
  if (mark == std::string::npos) return {};
  const std::size_t begin = mark + std::strlen(kMark);
  return text.substr(begin, text.find('\n', begin) - begin);
}

/// How many blocks a uniform of this type has, one a substep; 0 where it is not of that kind.
std::uint32_t steps_of(const std::string& type, const std::string& step) {
  if (step.empty()) return 0;
  return type == step ? 1 : type == "array<" + step + ",2>" ? 2 : 0;
}

Result<BindingKind> binding_kind(const std::string& address_space, const std::string& type) {
  if (address_space == "uniform") return BindingKind::Uniform;
  if (address_space == "storage" || address_space == "storage,read") return BindingKind::StorageRead;
  if (address_space == "storage,read_write") return BindingKind::StorageReadWrite;
  if (type.rfind("texture_depth_2d", 0) == 0) return BindingKind::DepthTexture;
  if (type.rfind("texture_2d", 0) == 0) return BindingKind::Texture;
  if (type == "sampler_comparison") return BindingKind::ComparisonSampler;
  if (type == "sampler") return BindingKind::Sampler;
  return make_error(ErrorKind::Shader, "A binding of address space \"%s\" and type \"%s\" is not known.",
                    address_space.c_str(), type.c_str());
}

}  // namespace

Result<std::vector<BindingLayout>> parse_bindings(const std::string& text) {
  const std::string step = step_type(text);
  std::vector<BindingLayout> bindings;
  for (std::size_t begin = text.find("@group(0)"); begin != std::string::npos;
       begin = text.find("@group(0)", begin + 1)) {
    const std::string line = text.substr(begin, text.find(';', begin) - begin);
    const std::size_t var = line.find(" var");
    const std::size_t colon = line.find(':');
    if (var == std::string::npos || colon == std::string::npos)
      return make_error(ErrorKind::Shader, "Binding \"%s\" is not declared on one line.", line.c_str());
    BindingLayout binding;
    binding.binding =
        static_cast<std::uint32_t>(std::atoi(between(line, '(', ')', line.find("@binding")).c_str()));
    const bool has_space = line[var + 4] == '<';
    const std::string space = has_space ? between(line, '<', '>', var) : "";
    const std::size_t name = has_space ? line.find('>', var) + 1 : var + 4;
    binding.name = between(" " + line.substr(name, colon - name) + ":", ' ', ':');
    const std::string type = between(line.substr(colon) + ";", ':', ';');
    WEFT_TRY(kind, binding_kind(space, type));
    binding.kind = kind;
    binding.steps = kind == BindingKind::Uniform ? steps_of(type, step) : 0;
    if (binding.steps > 0) binding.kind = BindingKind::StepUniform;
    bindings.push_back(std::move(binding));
  }
  std::sort(bindings.begin(), bindings.end(),
            [](const BindingLayout& a, const BindingLayout& b) { return a.binding < b.binding; });
  for (std::size_t i = 0; i < bindings.size(); ++i)
    if (bindings[i].binding != i)
      return make_error(ErrorKind::Shader, "Binding %s has number %u where %zu is next.",
                        bindings[i].name.c_str(), bindings[i].binding, i);
  return bindings;
}

Result<ShaderSource> ShaderSource::load(const std::string& path) {
  ShaderSource source;
  std::set<std::string> seen;
  WEFT_CHECK(append_with_includes(path, seen, source.text));
  auto bindings = parse_bindings(source.text);
  if (!bindings) return bindings.error().while_doing("reading shader " + path);
  source.bindings = std::move(*bindings);
  return source;
}

}  // namespace weft::gpu
