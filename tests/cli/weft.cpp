#include "weft.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "base/file.hpp"
#include "mesh/obj.hpp"
#include "source_path.hpp"

namespace weft {

std::string weft_binary() { return WEFT_BINARY; }

std::vector<std::string> weft_command(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), weft_binary());
  return arguments;
}

CallOptions on_lavapipe(CallOptions options) {
  std::vector<std::string> all = {
      "WEFT_MODELS=" + source_path("models"),
      "WEFT_SHADERS",
      "VK_DRIVER_FILES=" WEFT_LAVAPIPE,
      "VK_ICD_FILENAMES=" WEFT_LAVAPIPE,
      "XDG_RUNTIME_DIR",               // as in a container: drivers then talk about Wayland, weft must not
      "ASAN_OPTIONS=detect_leaks=0"};  // a driver may keep what it has until the process ends
  all.insert(all.end(), options.environment.begin(), options.environment.end());
  options.environment = std::move(all);
  return options;
}

Ended run_weft(std::vector<std::string> arguments, const CallOptions& options) {
  return call(weft_command(std::move(arguments)), on_lavapipe(options));
}

Ended run_without_driver(std::vector<std::string> arguments, CallOptions options) {
  for (const char* variable : {"VK_DRIVER_FILES=/nonexistent", "VK_ICD_FILENAMES=/nonexistent",
                               "ASAN_OPTIONS=quarantine_size_mb=1"})  // what is freed is not to count as used
    options.environment.emplace_back(variable);
  return run_weft(std::move(arguments), options);
}

std::string tiny_scene(const std::string& members, const std::string& cloth) {
  return R"({"format": "weft-scene/1", "time": {"substeps": 4, "frames": 3}, "render": {"size": [64, 48]}, )" +
         members + R"("cloths": [{"grid": [6, 5], "size": [1, 0.8], "density": 0.2, "damping": 0.01, )" +
         cloth +
         R"("stiffness": {"structural": 20, "shear": 8, "bend": 2}, "pins": ["top_left", "top_right"]}]})";
}

std::string scene_of_cloth(const std::string& keys) {
  return R"({"format": "weft-scene/1", "cloths": [{)" + keys + "}]}";
}

std::string put(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
  const std::string path = folder.path(name);
  const auto written = write_file(path, text);
  REQUIRE_MESSAGE(written, written.error().message);
  return path;
}

std::string read_text(const std::string& path) {
  const auto bytes = read_file(path, std::uint64_t{1} << 30U);
  REQUIRE_MESSAGE(bytes, bytes.error().message);
  return {reinterpret_cast<const char*>(bytes.value().data()), bytes.value().size()};
}

nlohmann::json json_of(const std::string& text) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  REQUIRE_MESSAGE(!json.is_discarded(), text);
  return json;
}

mesh::TriangleMesh read_obj_file(const std::string& path) {
  const std::string text = read_text(path);
  auto mesh = mesh::read_obj(std::as_bytes(std::span(text.data(), text.size())));
  REQUIRE_MESSAGE(mesh, mesh.error().message);
  return std::move(*mesh);
}

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  if (!std::filesystem::exists(folder)) return names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    names.push_back(entry.path().lexically_relative(folder).string());
  std::sort(names.begin(), names.end());
  return names;
}

std::size_t count_frames(const std::string& folder) {
  const auto names = names_in(folder);
  return static_cast<std::size_t>(std::count_if(names.begin(), names.end(), [](const std::string& name) {
    return name.rfind("frame_", 0) == 0 && name.size() == std::string("frame_00000.png").size();
  }));
}

bool has_program(const std::string& name) { return call({"/bin/sh", "-c", "command -v " + name}).code == 0; }

bool eventually(const std::function<bool()>& condition) {
  for (int k = 0; k < 200000 && !condition(); ++k) ::usleep(1000);
  return condition();
}

std::string check_message(const std::string& err) {
  if (err.rfind("weft: ", 0) != 0) return "does not begin with \"weft: \": " + err;
  if (err.back() != '\n' || err.find('\n') != err.size() - 1) return "is not one line: " + err;
  for (const char c : err.substr(0, err.size() - 1))
    if (static_cast<unsigned char>(c) < ' ') return "has a character that does not print";
  return {};
}

std::string check_refusal(const Ended& ended, int code, const std::string& words, std::size_t input) {
  // Bytes: the program itself takes some; the sanitizer has shadow memory and redzones.
  constexpr std::size_t kMaxConstant = std::size_t{kSanitized ? 256 : 64} << 20U;
  constexpr std::size_t kMaxGrowth = kSanitized ? 64 : 16;
  constexpr double kMaxTime = kSanitized ? 10 : 1;  // s of the processor, since others are at work too
  if (ended.code != code) return "ends with " + std::to_string(ended.code) + ": " + ended.err;
  if (!ended.out.empty()) return "says on stdout: " + ended.out;
  if (const std::string problem = check_message(ended.err); !problem.empty()) return problem;
  if (ended.err.size() > 600) return "has a message of " + std::to_string(ended.err.size()) + " characters";
  if (ended.err.find(words) == std::string::npos) return "says: " + ended.err;
  if (ended.cpu_s > kMaxTime) return "takes " + std::to_string(ended.cpu_s) + " s";
  if (ended.peak > kMaxConstant + kMaxGrowth * input)
    return "takes " + std::to_string(ended.peak) + " bytes for " + std::to_string(input);
  return {};
}

}  // namespace weft
