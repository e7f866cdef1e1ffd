#include "scene_source.hpp"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>

#include "base/file.hpp"
#include "base/json.hpp"
#include "common.hpp"
#include "scene/load.hpp"
#include "scene/nearest.hpp"

namespace weft::cli {
namespace {

constexpr const char* kStandardInput = "standard input";

bool is_name(const std::string& source) {
  return std::all_of(source.begin(), source.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
  });
}

std::string shipped_path(const std::string& name) {
  return folder_beside_program("scenes") + "/" + name + ".json";
}

Result<std::string> read_standard_input() {
  std::string text;
  char part[65536];
  for (;;) {
    const ssize_t count = ::read(STDIN_FILENO, part, sizeof part);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return input_error("Standard input cannot be read: %s.", std::strerror(errno));
    if (count == 0) return text;
    text.append(part, static_cast<std::size_t>(count));
    if (text.size() > kMaxJsonBytes)
      return input_error("Standard input has more than the limit of %zu bytes.", kMaxJsonBytes);
  }
}

Error no_such_scene(const std::string& name) {
  const std::vector<std::string> shipped = shipped_scenes();
  const std::vector<std::string_view> known(shipped.begin(), shipped.end());
  const std::string near(scene::nearest(name, known));
  return input_error(
      "There is no shipped scene %s%s; \"weft scenes\" lists them, and a path of a file has a \"/\" or a "
      "\".\".",
      in_quotes(name).c_str(), near.empty() ? "" : (", but there is " + in_quotes(near)).c_str());
}

}  // namespace

std::string beside_program(const std::string& name) {
  char path[PATH_MAX];
  const ssize_t length = ::readlink("/proc/self/exe", path, sizeof path - 1);
  if (length <= 0) return name;
  const std::filesystem::path program(std::string(path, static_cast<std::size_t>(length)));
  return (program.parent_path() / name).string();
}

std::string folder_beside_program(const std::string& name) {
  return (std::filesystem::path(beside_program("weft")).parent_path().parent_path() / name).string();
}

std::vector<std::string> shipped_scenes() {
  std::vector<std::string> names;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder_beside_program("scenes"), error), end;
       !error && entry != end; entry.increment(error))
    if (entry->path().extension() == ".json") names.push_back(entry->path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

Result<SceneSource> find_scene(const std::string& source) {
  if (source == "-") {
    WEFT_TRY(text, read_standard_input());
    return SceneSource{std::move(text), kStandardInput};
  }
  std::string path = source;
  if (is_name(source)) {
    path = shipped_path(source);
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) return no_such_scene(source);
  }
  WEFT_TRY(bytes, read_file(path, kMaxJsonBytes));
  return SceneSource{{reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path};
}

Result<scene::Scene> read_scene(const std::string& source, std::span<const scene::Override> overrides) {
  WEFT_TRY(found, find_scene(source));
  return scene::parse_scene(found.text, found.file, overrides);
}

}  // namespace weft::cli
