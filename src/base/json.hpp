// A JSON value, and a reader that refuses what no scene needs: duplicate keys, deep nesting, huge files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace weft {

inline constexpr std::size_t kMaxJsonBytes = std::size_t{16} << 20U;
inline constexpr std::size_t kMaxJsonNesting = 64;
inline constexpr std::size_t kMaxJsonValues = std::size_t{1} << 20U;  // some 100 MB of Json

struct Json {
  enum class Kind { Null, Boolean, Number, Text, List, Object };

  Kind kind = Kind::Null;
  bool boolean = false;
  double number = 0;  // whole numbers are exact up to 2^53, far above every limit of a scene
  std::string text;
  std::vector<std::string> names;  // of an object's values, in the order of the file
  std::vector<Json> values;        // of a list or an object

  /// The value of a key, or null if there is none.
  const Json* find(std::string_view name) const;
  Json* find(std::string_view name);
  /// Adds a key that the object lacks.
  Json& add(const std::string& name, Json value);
};

/// Reads a JSON text (RFC 8259; a byte order mark is skipped).
/// Errors  Input: not JSON, with line and column; a key given twice; over one of the limits above.
Result<Json> parse_json(std::string_view text, const std::string& file);

/// How a message speaks of a value: `-1`, `the text "abc"`, `a list of 3`, `an object`.
std::string describe(const Json& value);
/// A text in quotation marks, without control characters, and cut where it is long.
std::string in_quotes(std::string_view text);
/// A text as JSON.
std::string json_text(std::string_view text);
/// The shortest decimal number that reads back as the same double.
std::string number_text(double number);
/// The path of a key below another: "time" + "frame" is "time.frame"; a strange key is quoted.
std::string path_of_key(const std::string& path, std::string_view key);
std::string path_of_index(const std::string& path, std::size_t index);

}  // namespace weft
