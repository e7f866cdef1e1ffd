#include "base/json.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>

namespace weft {
namespace {

/// Line and column, both from 1, of the character that ends at `offset`.
std::string line_and_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset == 0 ? 0 : offset - 1, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t newline = before.rfind('\n');
  const std::size_t column = before.size() - (newline == std::string_view::npos ? 0 : newline + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// Receives nlohmann's events (its parser is not recursive) and builds a Json of bounded depth and size.
class Receiver {
 public:
  Receiver(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  bool null() { return scalar({}); }
  bool boolean(bool value) {
    Json json;
    json.kind = Json::Kind::Boolean;
    json.boolean = value;
    return scalar(std::move(json));
  }
  bool number_integer(std::int64_t value) { return number(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return number(static_cast<double>(value)); }
  bool number_float(double value, const std::string&) { return number(value); }
  bool string(std::string& value) {
    Json json;
    json.kind = Json::Kind::Text;
    json.text = std::move(value);
    return scalar(std::move(json));
  }
  bool binary(nlohmann::json::binary_t&) { return false; }  // only binary formats have it
  bool start_object(std::size_t) { return open(Json::Kind::Object); }
  bool start_array(std::size_t) { return open(Json::Kind::List); }
  bool key(std::string& name) {
    open_.back()->names.push_back(std::move(name));
    return true;
  }
  bool end_object() {
    std::vector<std::string> names = open_.back()->names;
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end())
      return fail(input_error("%s: %s is given twice.", file_.c_str(), path_of_key(path(), *twice).c_str()));
    open_.pop_back();
    return true;
  }
  bool end_array() {
    open_.pop_back();
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception& exception) {
    // "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error while ..."
    std::string reason = exception.what();
    reason.erase(0, reason.find("] ") + 2);
    if (reason.rfind("parse error", 0) == 0) reason.erase(0, reason.find(": ") + 2);
    if (reason.size() > kMaxReason) reason = reason.substr(0, kMaxReason) + " ...";
    return fail(
        input_error("%s: %s: %s.", file_.c_str(), line_and_column(text_, position).c_str(), reason.c_str()));
  }

  Result<Json> finish(bool parsed) {
    if (error_) return *error_;
    if (!parsed) return input_error("%s: the text is not JSON.", file_.c_str());
    return std::move(root_);
  }

 private:
  static constexpr std::size_t kMaxReason = 200;  // characters; nlohmann repeats the whole token

  bool fail(Error error) {
    error_ = std::move(error);
    return false;
  }
  bool number(double value) {
    Json json;
    json.kind = Json::Kind::Number;
    json.number = value;
    return scalar(std::move(json));
  }
  bool scalar(Json value) { return place(std::move(value)) != nullptr; }
  bool open(Json::Kind kind) {
    if (open_.size() == kMaxJsonNesting)
      return fail(
          input_error("%s: nesting is deeper than the limit of %zu levels.", file_.c_str(), kMaxJsonNesting));
    Json json;
    json.kind = kind;
    Json* opened = place(std::move(json));
    if (opened) open_.push_back(opened);
    return opened != nullptr;
  }
  Json* place(Json value) {
    if (++value_count_ > kMaxJsonValues) {
      fail(input_error("%s: there are more values than the limit of %zu.", file_.c_str(), kMaxJsonValues));
      return nullptr;
    }
    if (open_.empty()) return &(root_ = std::move(value));
    open_.back()->values.push_back(std::move(value));
    return &open_.back()->values.back();  // stays put: only the innermost open value grows
  }
  std::string path() const {
    std::string path;
    for (std::size_t k = 0; k + 1 < open_.size(); ++k) {
      const Json& json = *open_[k];
      path = json.kind == Json::Kind::Object ? path_of_key(path, json.names.back())
                                             : path_of_index(path, json.values.size() - 1);
    }
    return path;
  }

  std::string_view text_;
  const std::string& file_;
  Json root_;
  std::vector<Json*> open_;
  std::size_t value_count_ = 0;
  std::optional<Error> error_;
};

}  // namespace

const Json* Json::find(std::string_view name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? nullptr : &values[static_cast<std::size_t>(found - names.begin())];
}

Json* Json::find(std::string_view name) { return const_cast<Json*>(std::as_const(*this).find(name)); }

Json& Json::add(const std::string& name, Json value) {
  names.push_back(name);
  values.push_back(std::move(value));
  return values.back();
}

Result<Json> parse_json(std::string_view text, const std::string& file) {
  if (text.size() > kMaxJsonBytes)
    return input_error("%s: %zu bytes are more than the limit of %zu.", file.c_str(), text.size(),
                       kMaxJsonBytes);
  Receiver receiver(text, file);
  const bool parsed = nlohmann::json::sax_parse(text.begin(), text.end(), &receiver);
  return receiver.finish(parsed);
}

std::string describe(const Json& value) {
  switch (value.kind) {
    case Json::Kind::Null:
      return "null";
    case Json::Kind::Boolean:
      return value.boolean ? "true" : "false";
    case Json::Kind::Number:
      return number_text(value.number);
    case Json::Kind::Text:
      return "the text " + in_quotes(value.text);
    case Json::Kind::List:
      return "a list of " + std::to_string(value.values.size());
    case Json::Kind::Object:
      break;
  }
  return "an object";
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kMaxShown = 60;  // bytes
  std::size_t end = std::min(text.size(), kMaxShown);
  while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  std::string out = "\"";
  for (const char c : text.substr(0, end)) {
    const auto byte = static_cast<unsigned char>(c);
    char escape[8];
    std::snprintf(escape, sizeof escape, "\\u%04x", byte);
    out += byte < 0x20 || byte == 0x7F ? std::string(escape) : std::string(1, c);
  }
  return out + (end < text.size() ? " ...\"" : "\"");
}

std::string json_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    char escape[8];
    std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned char>(c));
    out += static_cast<unsigned char>(c) < 0x20 || c == '"' || c == '\\' ? std::string(escape)
                                                                         : std::string(1, c);
  }
  return out + '"';
}

std::string number_text(double number) {
  char digits[40];
  for (int precision = 1; precision <= 17; ++precision) {
    std::snprintf(digits, sizeof digits, "%.*g", precision, number);
    if (std::strtod(digits, nullptr) == number) break;
  }
  if (number > -1e10 && number < 1e10 && number == static_cast<double>(static_cast<long long>(number)))
    std::snprintf(digits, sizeof digits, "%.0f", number);  // 65536, not 7e+04 or 6.5536e+04
  return digits;
}

std::string path_of_key(const std::string& path, std::string_view key) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
  };
  if (key.empty() || key.size() > 60 || !std::all_of(key.begin(), key.end(), plain))
    return path + "[" + in_quotes(key) + "]";
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}

std::string path_of_index(const std::string& path, std::size_t index) {
  return path + "[" + std::to_string(index) + "]";
}

}  // namespace weft
