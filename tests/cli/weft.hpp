// The program under test, and the scenes that its tests give it.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "child.hpp"
#include "mesh/triangle_mesh.hpp"
#include "temporary_folder.hpp"

namespace weft {

#ifdef __SANITIZE_ADDRESS__
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

/// The path of the program.
std::string weft_binary();
/// Runs weft with these arguments, on lavapipe unless the options say otherwise.
Ended run_weft(std::vector<std::string> arguments, const CallOptions& options = {});
/// The same for a command that needs no adapter: no driver is to be found.
Ended run_without_driver(std::vector<std::string> arguments, CallOptions options = {});
/// The whole command and environment of `run_weft`, to be started and waited for apart.
std::vector<std::string> weft_command(std::vector<std::string> arguments);
CallOptions on_lavapipe(CallOptions options);

/// A scene of one sheet of 6 x 5 nodes that hangs from two corners for three frames of four substeps.
/// `members` are further keys of the scene, `cloth` of the cloth; both end with a comma.
std::string tiny_scene(const std::string& members = "", const std::string& cloth = "");
/// A scene of one cloth that has these keys.
std::string scene_of_cloth(const std::string& keys);

/// Writes a file of the folder and returns its path.
std::string put(const TemporaryFolder& folder, const std::string& name, const std::string& text);
std::string read_text(const std::string& path);
nlohmann::json json_of(const std::string& text);
mesh::TriangleMesh read_obj_file(const std::string& path);

/// The names of a folder's files, sorted.
std::vector<std::string> names_in(const std::string& folder);
std::size_t count_frames(const std::string& folder);
/// Whether this program is on PATH.
bool has_program(const std::string& name);
/// Waits until the condition holds; false if it does not within 200 s, which ends a hang only.
bool eventually(const std::function<bool()>& condition);

/// What is wrong with a call of weft check that must end with this code and a message of these words; empty
/// if nothing. `input` is the size of the files that it reads [bytes].
std::string check_refusal(const Ended& ended, int code, const std::string& words, std::size_t input);

/// What is wrong with a message: it must be one line that begins with "weft: " and prints; empty if nothing.
std::string check_message(const std::string& err);

}  // namespace weft
